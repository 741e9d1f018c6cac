// Every check reads its accessor once from beginning to end. Places are counted in numbers, not in elements,
// as the reference validator counts them.
#include "pipeline/validate/data_checks.h"

#include <cmath>

#include "pipeline/validate/numbers.h"

namespace barrido::scene::validation {
namespace {

// How far a length may be from 1: what rounding to 8 bits a component can do (the reference validator's
// figures).
constexpr double kUnitVec3Threshold = 0.00674;
constexpr double kUnitVec4Threshold = 0.00769;

std::string text(std::uint64_t number) { return std::to_string(number); }

void check_sparse_indices(Issues& issues, const Accessor& accessor, const Numbers& numbers,
                          const Place& place) {
  std::uint64_t previous = 0;
  for (std::uint64_t i = 0; i < accessor.sparse->count; ++i) {
    const std::uint64_t index = numbers.sparse_index(i);
    if (i > 0 && index <= previous) {
      issues.add(kAccessorSparseIndicesNonIncreasing, place, {text(i), text(index), text(previous)});
    }
    if (index >= accessor.count) {
      issues.add(kAccessorSparseIndexOob, place, {text(i), text(index), text(accessor.count)});
    }
    previous = index;
  }
}

/// Least, greatest and wrong numbers of one component.
struct Range {
  double least = 0, greatest = 0;
  std::uint64_t below = 0, above = 0;
};

void report_range(Issues& issues, const Accessor& accessor, std::span<const Range> ranges,
                  const Place& place) {
  const Place min_place(place, "min"), max_place(place, "max");
  for (std::size_t c = 0; c < accessor.min.size(); ++c) {
    const double given = accessor.min[c];
    if (given == ranges[c].least) continue;
    issues.add(kAccessorMinMismatch, Place(min_place, c), {shown(given), shown(ranges[c].least)});
    if (ranges[c].below == 0) continue;
    issues.add(kAccessorElementOutOfMinBound, Place(min_place, c), {text(ranges[c].below), shown(given)});
  }
  for (std::size_t c = 0; c < accessor.max.size(); ++c) {
    const double given = accessor.max[c];
    if (given == ranges[c].greatest) continue;
    issues.add(kAccessorMaxMismatch, Place(max_place, c), {shown(given), shown(ranges[c].greatest)});
    if (ranges[c].above == 0) continue;
    issues.add(kAccessorElementOutOfMaxBound, Place(max_place, c), {text(ranges[c].above), shown(given)});
  }
}

void check_values(Issues& issues, const Accessor& accessor, Numbers& numbers, const Place& place) {
  const std::size_t components = numbers.components();
  const bool has_min = !accessor.min.empty(), has_max = !accessor.max.empty();
  const bool is_float = accessor.component_type == kFloat;
  if (!is_float && !has_min && !has_max) return;
  std::vector<Range> ranges(components);
  for (std::uint64_t i = 0; i < numbers.count(); ++i) {
    for (std::size_t c = 0; c < components; ++c) {
      const double value = numbers.at(i, c);
      Range& range = ranges[c];
      if (!std::isfinite(value))
        issues.add(kAccessorInvalidFloat, place, {text(i * components + c), shown(value)});
      if (i == 0 || range.least > value) range.least = value;
      if (i == 0 || range.greatest < value) range.greatest = value;
      if (has_min && value < accessor.min[c]) ++range.below;
      if (has_max && value > accessor.max[c]) ++range.above;
    }
  }
  report_range(issues, accessor, ranges, place);
}

void check_unit_vectors(Issues& issues, const DataCheck& check, Numbers& numbers) {
  const std::size_t components = numbers.components();
  for (std::uint64_t i = 0; i < numbers.count(); ++i) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = numbers.normalized_at(i, c);
      sum += value * value;
    }
    const double length = std::sqrt(sum);
    const std::uint64_t first = i * components;
    if (std::abs(length - 1) > kUnitVec3Threshold) {
      issues.add(kAccessorVector3NonUnit, check.pointer, {text(first), text(first + 2), shown(length)});
    }
    if (check.kind != DataCheck::Kind::unit_vectors_and_sign) continue;
    const double sign = numbers.normalized_at(i, 3);
    if (sign != 1 && sign != -1) {
      issues.add(kAccessorInvalidSign, check.pointer, {text(first), text(first + 3), shown(sign)});
    }
  }
}

void check_clamped(Issues& issues, const DataCheck& check, Numbers& numbers) {
  for (std::uint64_t i = 0; i < numbers.count(); ++i) {
    for (std::size_t c = 0; c < numbers.components(); ++c) {
      const double value = numbers.at(i, c);
      if (value < 0 || value > 1) {
        issues.add(kAccessorNonClamped, check.pointer, {text(i * numbers.components() + c), shown(value)});
      }
    }
  }
}

void check_indices(Issues& issues, const DataCheck& check, Numbers& numbers, int component_type) {
  const double restart = greatest_of(component_type);
  double triangle[3] = {};
  std::uint64_t degenerate = 0;
  for (std::uint64_t i = 0; i < numbers.count(); ++i) {
    const double index = numbers.at(i, 0);
    if (index >= static_cast<double>(check.limit)) {
      const std::string last = check.limit == 0 ? "none" : text(check.limit - 1);
      issues.add(kAccessorIndexOob, check.pointer, {text(i), shown(index), last});
    }
    if (index == restart) issues.add(kAccessorIndexPrimitiveRestart, check.pointer, {shown(index), text(i)});
    triangle[i % 3] = index;
    if (i % 3 == 2 &&
        (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])) {
      ++degenerate;
    }
  }
  if (check.flag && degenerate > 0) {
    issues.add(kAccessorIndexTriangleDegenerate, check.pointer,
               {text(degenerate), text(numbers.count() / 3)});
  }
}

void check_inverse_bind(Issues& issues, const DataCheck& check, Numbers& numbers) {
  for (std::uint64_t i = 0; i < numbers.count(); ++i) {
    for (std::size_t c = 3; c < 16; c += 4) {
      const double value = numbers.at(i, c);
      if (value == (c == 15 ? 1 : 0)) continue;
      issues.add(kAccessorInvalidIbm, check.pointer, {text(i * 16 + c), text(c), shown(value)});
    }
  }
}

void check_times(Issues& issues, const DataCheck& check, Numbers& numbers) {
  double previous = 0;
  for (std::uint64_t i = 0; i < numbers.count(); ++i) {
    const double time = numbers.at(i, 0);
    if (time < 0) {
      issues.add(kAccessorAnimationInputNegative, check.pointer, {text(i), shown(time)});
      continue;
    }
    if (i > 0 && time <= previous) {
      issues.add(kAccessorAnimationInputNonIncreasing, check.pointer,
                 {text(i), shown(time), shown(previous)});
    }
    previous = time;
  }
}

void check_rotations(Issues& issues, const DataCheck& check, Numbers& numbers) {
  const bool has_tangents = check.flag;
  for (std::uint64_t i = 0; i < numbers.count(); ++i) {
    double sum = 0;
    for (std::size_t c = 0; c < 4; ++c) {
      const double value = numbers.normalized_at(i, c);
      sum += value * value;
    }
    const bool is_tangent = has_tangents && i % 3 != 1;
    if (is_tangent || std::abs(std::sqrt(sum) - 1) <= kUnitVec4Threshold) continue;
    issues.add(kAccessorAnimationSamplerOutputNonNormalizedQuaternion, check.pointer,
               {text(i * 4), text(i * 4 + 3), shown(std::sqrt(sum))});
  }
}

void run_check(Link& link, const DataCheck& check, Budget& budget) {
  const Accessor& accessor = link.model.accessors[check.accessor];
  Numbers numbers(link.model, accessor);
  if (!numbers.readable() || !budget.take(numbers.count() * numbers.components())) return;
  switch (check.kind) {
    case DataCheck::Kind::unit_vectors:
    case DataCheck::Kind::unit_vectors_and_sign:
      return check_unit_vectors(link.issues, check, numbers);
    case DataCheck::Kind::clamped:
      return check_clamped(link.issues, check, numbers);
    case DataCheck::Kind::indices:
      return check_indices(link.issues, check, numbers, accessor.component_type);
    case DataCheck::Kind::inverse_bind:
      return check_inverse_bind(link.issues, check, numbers);
    case DataCheck::Kind::times:
      return check_times(link.issues, check, numbers);
    case DataCheck::Kind::rotations:
      return check_rotations(link.issues, check, numbers);
  }
}

}  // namespace

void check_data(Link& link, Budget& budget) {
  const Place root, accessors_place(root, "accessors");
  for (std::size_t i = 0; i < link.model.accessors.size(); ++i) {
    const Accessor& accessor = link.model.accessors[i];
    Numbers numbers(link.model, accessor);
    // Sparse elements are searched for, so that each costs more than a number.
    if (!numbers.readable() || !budget.take(numbers.count() * numbers.components())) continue;
    const Place place(accessors_place, i);
    if (accessor.sparse) check_sparse_indices(link.issues, accessor, numbers, Place(place, "sparse"));
    check_values(link.issues, accessor, numbers, place);
  }
  for (const DataCheck& check : link.data_checks) run_check(link, check, budget);
  check_influences(link, budget);
}

}  // namespace barrido::scene::validation
