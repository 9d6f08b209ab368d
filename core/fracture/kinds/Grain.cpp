#include "core/fracture/kinds/Grain.h"

#include "core/base/math/Trigonometry.h"
#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"

#include <numbers>

namespace rubble {
namespace {

constexpr double kMaxGrainRatio = 20.0;  // more would cost digits of points on the outline's edges

constexpr std::array kGrainParameters{
    parameter<&Grain::angle>({.name = "angle",
                              .caption = "Angle",
                              .hint = "Direction of the grain; 0: horizontal",
                              .quantity = Quantity::Angle,
                              .range = {-kMaxAngle, kMaxAngle},
                              .sliderRange = {-std::numbers::pi, std::numbers::pi}}),
    parameter<&Grain::ratio>({.name = "ratio",
                              .caption = "Ratio",
                              .hint = "Mean length of fragments divided by their mean width",
                              .range = {1.0, kMaxGrainRatio},
                              .sliderRange = {1.0, 10.0}}),
    parameter<&Grain::tilt>(tiltParameter("Tilt of the grain out of the xy plane; 90°: along z")),
};

}  // namespace

constinit const LayerKind Grain::kKind{.name = "grain",
                                       .caption = "Grain",
                                       .hint = "Elongates the cells of all seeds",
                                       .icon = "layer-grain",
                                       .summary = "1 : {ratio}",
                                       .role = LayerRole::Measures,
                                       .parameters = kGrainParameters};

}  // namespace rubble
