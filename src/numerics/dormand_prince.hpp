#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace sigmasweep {

/// The explicit Runge-Kutta scheme of order 8 by Dormand and Prince with embedded error estimates of orders 5 and 3,
/// DOP853: E. Hairer, S. P. Norsett & G. Wanner, Solving Ordinary Differential Equations I (1993), II.5 and II.10. The
/// estimates use slopes from the whole step, so that they see a kink within it.
template <class Real, class Vector = std::vector<Real>>
class DormandPrince {
 public:
  using State = Vector;  ///< std::vector or std::array

  /// Makes a step of length `span` from the state `start` with slope `start_slope` at time `at` to the state `end`.
  /// Returns the estimate of the largest error of a component. system(state, slope, at) computes the slope.
  template <class System>
  Real step(System&& system, const State& start, const State& start_slope, const Real& at, const Real& span,
            State& end) {
    if constexpr (requires(State & k) { k.resize(1); })
      for (State& k : slope_) k.resize(start.size());
    std::copy(start_slope.begin(), start_slope.end(), slope_[0].begin());
    stages(system, start, at, span, end, std::make_index_sequence<count - 1>());
    advance<count>(start, span, end, std::make_index_sequence<count>());
    return error(span, std::make_index_sequence<count>());
  }

 private:
  static constexpr std::size_t count = 12;
  using Row = std::array<long double, count>;

  template <class System, std::size_t... Stage>
  void stages(System& system, const State& start, const Real& at, const Real& span, State& between,
              std::index_sequence<Stage...>) {
    (stage<Stage + 1>(system, start, at, span, between), ...);
  }

  template <std::size_t Stage, class System>
  void stage(System& system, const State& start, const Real& at, const Real& span, State& between) {
    advance<Stage>(start, span, between, std::make_index_sequence<Stage>());
    system(between, slope_[Stage], at + Real(nodes[Stage]) * span);
  }

  /// y = start + span sum_j a_j k_j with row `Stage` of the weights; the last row gives the end of the step.
  template <std::size_t Stage, std::size_t... J>
  void advance(const State& start, const Real& span, State& y, std::index_sequence<J...>) {
    const std::array<const Real*, sizeof...(J)> k{slope_[J].data()...};
    const Real* from = start.data();
    Real* to = y.data();
#pragma GCC ivdep
    for (std::size_t e = 0, n = start.size(); e < n; ++e) to[e] = from[e] + span * (term<Stage, J>(k[J][e]) + ...);
  }
  template <std::size_t Stage, std::size_t J>
  static Real term(const Real& slope) {
    if constexpr (weights[Stage][J] == 0.0L)
      return Real(0);
    else
      return Real(weights[Stage][J]) * slope;
  }

  template <std::size_t... J>
  Real error(const Real& span, std::index_sequence<J...>) const {
    using std::fabs, std::sqrt;
    Real fifth = 0, third = 0;
    for (std::size_t e = 0, n = slope_[0].size(); e < n; ++e) {
      const Real e5 = fabs(((Real(fifth_order[J]) * slope_[J][e]) + ...));
      const Real e3 = fabs(((Real(weights[count][J] - third_order[J]) * slope_[J][e]) + ...));
      if (!(e5 <= fifth)) fifth = e5;  // keeps NaN
      if (!(e3 <= third)) third = e3;
    }
    if (fifth == Real(0)) return Real(0);
    return fabs(span) * fifth * fifth / sqrt(fifth * fifth + Real(0.01) * third * third);
  }

  static constexpr Row nodes{0.0L,
                             0.526001519587677318785587544488e-1L,
                             0.789002279381515978178381316732e-1L,
                             0.118350341907227396726757197510L,
                             0.281649658092772603273242802490L,
                             1.0L / 3.0L,
                             0.25L,
                             4.0L / 13.0L,
                             0.651282051282051282051282051282L,
                             0.6L,
                             6.0L / 7.0L,
                             1.0L};
  static constexpr std::array<Row, count + 1> weights{
      {{},
       {5.26001519587677318785587544488e-2L},
       {1.97250569845378994544595329183e-2L, 5.91751709536136983633785987549e-2L},
       {2.95875854768068491816892993775e-2L, 0, 8.87627564304205475450678981324e-2L},
       {2.41365134159266685502369798665e-1L, 0, -8.84549479328286085344864962717e-1L,
        9.24834003261792003115737966543e-1L},
       {1.0L / 27.0L, 0, 0, 1.70828608729473871279604482173e-1L, 1.25467687566822425016691814123e-1L},
       {3.7109375e-2L, 0, 0, 1.70252211019544039314978060272e-1L, 6.02165389804559606850219397283e-2L, -1.7578125e-2L},
       {3.70920001185047927108779319836e-2L, 0, 0, 1.70383925712239993810214054705e-1L,
        1.07262030446373284651809199168e-1L, -1.53194377486244017527936158236e-2L, 8.27378916381402288758473766002e-3L},
       {6.24110958716075717114429577812e-1L, 0, 0, -3.36089262944694129406857109825L,
        -8.68219346841726006818189891453e-1L, 27.5920996994467083049415600797L, 20.1540675504778934086186788979L,
        -43.4898841810699588477366255144L},
       {4.77662536438264365890433908527e-1L, 0, 0, -2.48811461997166764192642586468L,
        -5.90290826836842996371446475743e-1L, 21.2300514481811942347288949897L, 15.2792336328824235832596922938L,
        -33.2882109689848629194453265587L, -2.03312017085086261358222928593e-2L},
       {-9.3714243008598732571704021658e-1L, 0, 0, 5.18637242884406370830023853209L, 1.09143734899672957818500254654L,
        -8.14978701074692612513997267357L, -18.5200656599969598641566180701L, 22.7394870993505042818970056734L,
        2.49360555267965238987089396762L, -3.0467644718982195003823669022L},
       {2.27331014751653820792359768449L, 0, 0, -10.5344954667372501984066689879L, -2.00087205822486249909675718444L,
        -17.9589318631187989172765950534L, 27.9488845294199600508499808837L, -2.85899827713502369474065508674L,
        -8.87285693353062954433549289258L, 12.3605671757943030647266201528L, 6.43392746015763530355970484046e-1L},
       {5.42937341165687622380535766363e-2L, 0, 0, 0, 0, 4.45031289275240888144113950566L,
        1.89151789931450038304281599044L, -5.8012039600105847814672114227L, 3.1116436695781989440891606237e-1L,
        -1.52160949662516078556178806805e-1L, 2.01365400804030348374776537501e-1L,
        4.47106157277725905176885569043e-2L}}};
  static constexpr Row fifth_order{0.1312004499419488073250102996e-1L,
                                   0,
                                   0,
                                   0,
                                   0,
                                   -0.1225156446376204440720569753e+1L,
                                   -0.4957589496572501915214079952L,
                                   0.1664377182454986536961530415e+1L,
                                   -0.3503288487499736816886487290L,
                                   0.3341791187130174790297318841L,
                                   0.8192320648511571246570742613e-1L,
                                   -0.2235530786388629525884427845e-1L};
  static constexpr Row third_order{
      0.244094488188976377952755905512L,   0, 0, 0, 0, 0, 0, 0, 0.733846688281611857341361741547L, 0, 0,
      0.220588235294117647058823529412e-1L};

  std::array<State, count> slope_{};
};

}  // namespace sigmasweep
