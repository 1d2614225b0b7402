"""Random tuples over all geometries, methods, laws and integrators, as options of `sigmasweep one`.

The tuples depend on the seed only. Their sizes are limited so that each of them takes less than a second.
"""

import random

LAWS = ["hooke", "hertz", "hertz-kuwabara-kono", "taguchi", "power"]
FIXED_STEPS = ["gear5", "verlet", "rk4"]


def decades(draw, low, high):
    return f"{10 ** draw.uniform(low, high):.6g}"


def stiffness(draw, law, hard):
    """Options that give spring and dashpot: by tc and epsilon, by K_over_m and D_n, or by a material."""
    if law in ("hertz", "hertz-kuwabara-kono") and draw.random() < 0.2 and not hard:
        return {"material": draw.choice(["steel", "aluminium"])}
    if law == "hooke" and draw.random() < 0.2:
        spring = 10 ** draw.uniform(8, 12)
        ratio = draw.uniform(0, 0.9 if hard else 1.2)  # over-damped pairs, too
        return {"K_over_m": f"{spring:.6g}", "D_n": f"{ratio * spring ** 0.5:.6g}"}
    return {"tc": decades(draw, -6, -3), "epsilon": f"{draw.uniform(0.3, 1):.4f}"}


def soft_spheres(draw, options, laws):
    law = draw.choice(laws)
    options["law"] = law
    if law == "power":
        options.update(beta=f"{draw.uniform(0, 1):.3f}", gamma=f"{draw.uniform(0, 1):.3f}")
    options["integrator"] = draw.choice(["exact"] + FIXED_STEPS)
    if options["integrator"] != "exact":
        options["steps_per_tc"] = str(draw.randint(20, 60))
    return law


def unequal(draw, options):
    if draw.random() < 0.4:
        options.update(width="3e-4", seed=str(draw.randint(1, 9999)))


def column(draw):
    hard = draw.random() < 0.25
    options = {"geometry": "column", "N": str(draw.randint(1, 16)), "v0": decades(draw, -2, 1)}
    options["wall"] = draw.choice(["paper", "matched"])
    law = "hooke"
    if hard:
        options.update(method="ed", ed_rule=draw.choice(["lrv", "tc"]))
    else:
        law = soft_spheres(draw, options, LAWS)
        if options["integrator"] == "exact":
            options["tolerance"] = draw.choice(["1e-4", "1e-7", "1e-10"])
        elif draw.random() < 0.3:
            del options["steps_per_tc"]
            options["tolerance"] = "1e-3"
    options.update(stiffness(draw, law, hard))
    options["sigma"] = draw.choice(["0", decades(draw, -3, 2)])
    unequal(draw, options)
    if options["sigma"] != "0" and draw.random() < 0.3:
        options.update(random_separation="true", seed=str(draw.randint(1, 9999)))
    return options


def vibrated(draw, options):
    options.update(frequency="20", periods="4", transient="1", alpha=f"{draw.uniform(0.5, 6):.3f}")
    options.update(tc=decades(draw, -4, -2.5), epsilon=f"{draw.uniform(0.3, 1):.4f}")


def vibrated_column(draw):
    options = {"geometry": "vibrated-column", "N": str(draw.randint(1, 8))}
    if draw.random() < 0.3:
        options.update(method="ed", ed_rule=draw.choice(["lrv", "tc"]))
    elif soft_spheres(draw, options, ["hooke", "hooke", "hertz", "taguchi"]) != "hooke":
        options["v0"] = "0.5"
    vibrated(draw, options)
    if options.get("method") == "ed" and options["ed_rule"] == "lrv":
        del options["tc"]
    unequal(draw, options)
    return options


def lattice_size(draw, options):
    options.update(rows=str(draw.randint(1, 4)), columns=str(draw.randint(2, 5)))
    options.update(side_walls=draw.choice(["periodic", "fixed"]), D_t=draw.choice(["0", "1e3"]))


def lattice(draw):
    options = {"geometry": "lattice", "v0": decades(draw, -1, 0.5), "tolerance": "1e-3"}
    law = soft_spheres(draw, options, ["hooke", "hooke", "hertz"])
    options.update(tc=decades(draw, -5, -4), epsilon=f"{draw.uniform(0.5, 1):.4f}", sigma=decades(draw, -2, 0.5))
    lattice_size(draw, options)
    if options["integrator"] != "exact":
        del options["tolerance"]
    if law == "hooke" and draw.random() < 0.5:
        options.update(random_separation="true", seed=str(draw.randint(1, 9999)))
    return options


def vibrated_lattice(draw):
    options = {"geometry": "vibrated-lattice"}
    if soft_spheres(draw, options, ["hooke", "hooke", "hertz"]) != "hooke":
        options["v0"] = "0.5"
    vibrated(draw, options)
    options.update(tc=decades(draw, -3, -2.5), periods="2")
    lattice_size(draw, options)
    return options


def random_tuples(count, seed):
    draw = random.Random(seed)
    scenes = [column] * 5 + [vibrated_column] * 2 + [lattice] * 2 + [vibrated_lattice]
    return [draw.choice(scenes)(draw) for _ in range(count)]
