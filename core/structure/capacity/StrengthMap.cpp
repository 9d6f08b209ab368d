#include "core/structure/capacity/StrengthMap.h"

#include "core/asset/project/AssetShape.h"
#include "core/geometry/predicates/SegmentDistance.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

/// The factor of one pixel, from column and row.
double factorOfPixel(const StrengthImage& image, std::uint32_t column, std::uint32_t row) {
    const GreyImage& pixels = *image.image;
    const std::size_t pixel = std::size_t{row} * pixels.width + column;
    const double white = pixels.white();
    const double factor = image.darkest + pixels.grey[pixel] / white * (image.brightest - image.darkest);
    const double opacity = pixels.opacity.empty() ? 1.0 : pixels.opacity[pixel] / white;
    return 1.0 + opacity * (factor - 1.0);
}

/// A place between two pixels of a row or column.
struct PixelStep {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    double fraction = 0.0;  // of the way from low to high
};

/// From a position in [0, 1] along `count` pixels; positions beyond the outermost centres are at these.
PixelStep pixelStep(double position, std::uint32_t count) {
    const double place = std::clamp(position * count - 0.5, 0.0, count - 1.0);
    const auto low = static_cast<std::uint32_t>(place);
    return {low, std::min(low + 1, count - 1), place - low};
}

}  // namespace

StrengthMap::StrengthMap(const Asset& asset) : m_bonding(asset.bonding), m_bounds(planeBoundsOf(asset)) {}

double StrengthMap::at(Vec2 point) const {
    return byStroke(point) * byHeight(point.y - m_bounds.min.y) * byImage(point);
}

double StrengthMap::byStroke(Vec2 point) const {
    for (std::size_t k = m_bonding.strokes.size(); k-- > 0;) {
        const BondStroke& stroke = m_bonding.strokes[k];
        if (stroke.brush != BondBrush::Strength || !covers(stroke, point)) continue;
        return stroke.isErasing ? 1.0 : stroke.strength;
    }
    return 1.0;
}

double StrengthMap::byHeight(double height) const {
    const std::vector<HeightStrength>& heights = m_bonding.heightStrengths;
    if (heights.empty()) return 1.0;
    const auto above = std::ranges::upper_bound(heights, height, {}, &HeightStrength::height);
    if (above == heights.begin()) return heights.front().factor;
    if (above == heights.end()) return heights.back().factor;
    const HeightStrength &low = *(above - 1), &high = *above;
    return low.factor + (height - low.height) / (high.height - low.height) * (high.factor - low.factor);
}

double StrengthMap::byImage(Vec2 point) const {
    if (!m_bonding.strengthImage || !m_bonding.strengthImage->image) return 1.0;
    const StrengthImage& image = *m_bonding.strengthImage;
    const Vec2 position = (point - m_bounds.min) / m_bounds.size();
    const PixelStep column = pixelStep(position.x, image.image->width),
                    row = pixelStep(1.0 - position.y, image.image->height);  // rows run downwards
    const auto ofRow = [&](std::uint32_t at) {
        const double low = factorOfPixel(image, column.low, at), high = factorOfPixel(image, column.high, at);
        return low + column.fraction * (high - low);
    };
    const double upper = ofRow(row.low), lower = ofRow(row.high);
    return upper + row.fraction * (lower - upper);
}

bool covers(const BondStroke& stroke, Vec2 point) {
    for (std::size_t k = 0; k < stroke.points.size(); ++k) {
        const Vec2 from = stroke.points[k], to = stroke.points[std::min(k + 1, stroke.points.size() - 1)];
        if (distanceToSegment(point, from, to) <= stroke.radius) return true;
    }
    return false;
}

}  // namespace rubble
