// SPDX-License-Identifier: Apache-2.0
// The horn case of a close pass: its near side may come into reach, leave it around its cusps, and
// come back. Included after horn_walk_kernel.h, once per instruction set.

/// The crossings of the circle |w| = R: inwards, outwards, inwards.
template <typename Real>
struct Crossings {
  using Mask = decltype(Real() < Real());
  std::array<Bracket<Real>, kMostCrossings> between;
  std::array<Mask, kMostCrossings> found;
  Mask all;  // there are no others
};

template <typename Real>
AVO_KERNEL NearSide<Real> select(decltype(Real() < Real()) mask, const NearSide<Real>& yes,
                                 const NearSide<Real>& no) {
  NearSide<Real> side;
  for (Real At<Real>::*number :
       {&At<Real>::time, &At<Real>::gain, &At<Real>::rate, &At<Real>::per_rate, &At<Real>::lag}) {
    side.at.*number = select(mask, yes.at.*number, no.at.*number);
  }
  using Side = NearSide<Real>;
  for (Real Side::*number : {&Side::lead, &Side::per_y2, &Side::l2, &Side::l, &Side::b2,
                             &Side::tangential, &Side::cusp}) {
    side.*number = select(mask, yes.*number, no.*number);
  }
  return side;
}

// As walk(), but halves a stride on which |b| turns near R, or may turn twice, and goes on past a
// crossing. Once `settled`, |b| can only fall through R, once, up to τ.
template <typename Real>
AVO_KERNEL Crossings<Real> follow(const Horn<Real>& horn, const Passage<Real>& passage,
                                  const ResponseTable& table) {
  using Lanes = decltype(Real() < Real());
  const Real R = horn.pair.R, tau = table.end, t_m = passage.t_m;
  const Strides<Real> stride = strides(horn, t_m, table);
  Lanes active = passage.ordinary & (passage.first < tau);
  Real t = min(max(passage.first, t_m), tau), last = t;
  NearSide<Real> from = near_side(horn, at(table, t), table);
  Real from_length = length_of(from);
  Lanes inside = from_length <= R, lost = active & (!active), doubt = lost;
  const Real one = Real(1.0), tolerance = Real(kCloseTolerance);
  const Bracket<Real> fall{passage.first, t, first_time(horn, table), one, tolerance};
  const Bracket<Real> rise{t, tau, t, -one, tolerance};
  Crossings<Real> result{{fall, rise, fall}, {active & inside, lost, lost}, lost};
  for (int i = 0; i < 2 * kMaxPieces; ++i) {
    const auto outruns = horn.speed <= R * from.at.rate;
    const auto settled = outruns & (from.at.lag >= t_m) & (from.cusp >= Real(0.0));
    const auto stays = outruns & (norm(horn.pair.x(from.at)) <= R * from.at.gain);
    active = active & (!((inside & (settled | stays)) | (t >= tau)));
    if (!any(active)) break;
    Real next = select(settled, tau, min(stride.next(t), tau));
    next = select(doubt, Real(0.5) * (t + last), next);
    const NearSide<Real> to = near_side(horn, at(table, next), table);
    const Real to_length = length_of(to);
    const auto near_cusp =
        (abs(from.cusp) < Real(kFlat) * from.l2) | (abs(to.cusp) < Real(kFlat) * to.l2);
    const auto wide = (next - t > Real(kWide) * t) &
                      (min(abs(from_length - R), abs(to_length - R)) < Real(kWide) * R);
    doubt = active & (!settled) &
            (turns_near(from, from_length, to, to_length, R) | (near_cusp & wide));
    const auto moves = active & (!doubt), now_inside = to_length <= R;
    const auto enters = moves & now_inside & (!inside), leaves = moves & inside & (!now_inside);
    const std::array<Lanes, kMostCrossings> crosses{
        enters & (!result.found[0]), leaves & (!result.found[1]), enters & result.found[1]};
    lost = lost | (leaves & result.found[1]);
    const Real guess = t + (next - t) * ((from_length - R) /
                                         select(enters | leaves, from_length - to_length, one));
    for (std::size_t k = 0; k < kMostCrossings; ++k) {
      Bracket<Real>& between = result.between[k];
      between.low = select(crosses[k], t, between.low);
      between.high = select(crosses[k], next, between.high);
      between.guess = select(crosses[k], guess, between.guess);
      result.found[k] = result.found[k] | crosses[k];
    }
    inside = (inside & (!moves)) | (moves & now_inside);
    from = select(moves, to, from), from_length = select(moves, to_length, from_length);
    t = select(moves, next, t), last = next;
    active = active & (!lost);
  }
  result.all = passage.ordinary & (!(active | lost));
  return result;
}
