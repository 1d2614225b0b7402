#pragma once

#include <vector>

#include <toml++/toml.h>

namespace sigmasweep::spec {

/// The tables of a spec that give parameters: [defaults], [sweep], or each of several [[sweep]].
std::vector<const toml::table*> sweep_tables(const toml::table& spec);

}  // namespace sigmasweep::spec
