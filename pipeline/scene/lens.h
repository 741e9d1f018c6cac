// The thin lens (V12): where on it a sample's rays pass, and what the eye sees from there. Everything at the
// focus distance stays where it is; a point at the distance d becomes a disc as wide as the lens's diameter
// times |1/d − 1/focus|, seen from a unit away (the circle of confusion).
#pragma once

#include "pipeline/scene/frame.h"

namespace barrido::scene {

struct Lens {
  double radius = 0.0;  ///< The model's units; 0: a pinhole.
  double focus = 1.0;   ///< Distance along the line of sight, above 0.
};

/// The lens that the settings ask for, of a posed scene. Of an f-stop the radius is f/(2N), with the focal
/// length f that gives the view's angle on a picture 24 mm high; parallel rays have none, which is a warning.
/// `focus_from_pixel`: where SampleChoice::focus_pixel is given, the distance seen there, or 0.
Lens choose_lens(const Scene& scene, const PosedScene& posed, const RenderSettings& settings,
                 double focus_from_pixel, std::vector<std::string>& warnings);

/// The view from (x, y) on the lens, eye space; the plane of focus stands still (Haeberli and Akeley 1990).
View through_lens(const View& view, const Lens& lens, double x, double y);

/// Distance along the line of sight of what has the window depth `depth`; 0 where there is nothing.
double distance_at(const View& view, float depth);

}  // namespace barrido::scene
