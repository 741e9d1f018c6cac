// One set of samples for everything that a pixel is an average over: its area, the time that the shutter is
// open, and the lens. N samples lie in N cells of equal size in each of them; which cell of one goes with
// which of another is shuffled, so that each is well spread by itself and none follows another. Nothing is
// stored: all of it comes from the number of the sample and the seed.
#pragma once

#include <cstdint>
#include <vector>

#include "raster/tiles/pixel_filter.h"
#include "raster/tiles/samples.h"

namespace barrido::raster {

/// Cell `number` of a unit square that is cut into `count` of equal area: rows of cells, as many as the root
/// of `count` is near to, whose lengths differ by at most one. n² cells are an n×n grid.
struct SquareCell {
  double x_begin, x_end, y_begin, y_end;
};
SquareCell square_cell(int number, int count);

/// The samples of a pixel, in the middles of the cells of the square that the filter covers, each at a
/// multiple of 1/256 pixel and with the filter's value there as its weight. `count` ≥ 1.
/// Where the filter is 0 at all of them, weights are 1.
std::vector<Sample> uniform_samples(int count, const PixelFilter& filter);

/// Weights added up in their order, in floats.
float total_weight(const std::vector<Sample>& samples);

/// When and through which place of the lens a sample is looked at.
struct SampleMoment {
  double time = 0.5;                  ///< Of the time that the shutter is open, 0 to 1.
  double lens_x = 0.0, lens_y = 0.0;  ///< In the unit disc.
};

/// `random`: anywhere in its cell, else in its middle.
SampleMoment sample_moment(int number, int count, std::uint32_t seed, bool random);

}  // namespace barrido::raster
