#include "core/io/media/PatternSvg.h"

#include "core/base/QuantityText.h"
#include "core/base/Random.h"
#include "core/io/media/SvgWriter.h"
#include "core/io/text/NumberText.h"
#include "core/io/text/XmlText.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>

namespace rubble {
namespace {

// In pixels.
constexpr double kColumnWidth = 360.0;
constexpr double kMaxHeight = 320.0;  // so that a tower does not fill the screen
constexpr double kSpace = 32.0;       // around everything
constexpr double kBleed = 10.0;       // around an outline, in which seeds outside of it are shown
constexpr double kTitleHeight = 50.0;
constexpr double kScaleBarHeight = 34.0;
constexpr double kLegendHeight = 24.0;
constexpr std::size_t kMaxColumns = 3;

// Light enough for lines and dots to stand out, and distinct from each other.
constexpr std::array<std::string_view, 8> kCellColours = {"#f6d5c3", "#cfe3d4", "#f8e8b8", "#cddcef",
                                                          "#ead3e4", "#dfe8c2", "#c8e4e6", "#e3d9c9"};

/// Returns metres rounded to millimetres, exact if that would be zero.
std::string lengthText(double metres) {
    const double rounded = std::round(metres * 1000.0) / 1000.0;
    return numberText(rounded > 0.0 ? rounded : metres);
}

/// The place of a panel in the drawing and its scale.
struct Frame {
    Box2 bounds;         // of the outlines, m
    double scale = 1.0;  // pixels a metre
    Vec2 corner;         // of the drawing, top left

    Vec2 size() const { return bounds.size() * scale; }
    Vec2 pixels(Vec2 point) const { return corner + Vec2(point.x - bounds.min.x, bounds.max.y - point.y) * scale; }
};

/// Returns the frame of a panel that is some columns wide, with a proportional height.
Frame frameOf(const PatternPanel& panel, double columns) {
    Frame frame;
    for (const Polygon& outline : panel.outlines) {
        for (const Vec2 corner : outline.outer) frame.bounds.include(corner);
    }
    const Vec2 size = frame.bounds.size();
    frame.scale =
        std::min((columns * kColumnWidth - 2.0 * kBleed) / size.x, (columns * kMaxHeight - 2.0 * kBleed) / size.y);
    return frame;
}

/// Arranges frames in rows and returns their total height.
double arrange(std::vector<Frame>& frames) {
    double top = kSpace;
    for (std::size_t row = 0; row < frames.size(); row += kMaxColumns) {
        const std::size_t end = std::min(row + kMaxColumns, frames.size());
        double tallest = 0.0;
        for (std::size_t i = row; i < end; ++i) tallest = std::max(tallest, frames[i].size().y);
        for (std::size_t i = row; i < end; ++i) {
            const double left = kSpace + static_cast<double>(i - row) * (kColumnWidth + kSpace) + kBleed;
            frames[i].corner = {left, top + kTitleHeight + kBleed};
        }
        top += kTitleHeight + 2.0 * kBleed + tallest + kScaleBarHeight + kSpace;
    }
    return top;
}

void appendRing(SvgWriter& svg, const Frame& frame, std::span<const Vec2> ring, Vec2 origin) {
    for (std::size_t i = 0; i < ring.size(); ++i) svg << (i == 0 ? 'M' : 'L') << frame.pixels(origin + ring[i]);
    svg << 'Z';
}

void appendPolygon(SvgWriter& svg, const Frame& frame, const Polygon& polygon, Vec2 origin) {
    appendRing(svg, frame, polygon.outer, origin);
    for (const Ring& hole : polygon.holes) appendRing(svg, frame, hole, origin);
}

/// Returns a hash of a piece's seed and its cells in cut layers.
std::uint64_t keyOf(const Partition& partition, std::uint32_t piece) {
    std::uint64_t key = partition.seedOfPiece[piece];
    for (const std::uint32_t cell : partition.cutCellsOf(piece)) key = mixSeeds(key, cell);
    return key;
}

/// Returns whether a piece has the same seed and cells as the pieces from `first` up to it and no cut separates them.
bool hasSameColour(const Partition& partition, std::uint32_t first, std::uint32_t piece) {
    if (partition.seedOfPiece[piece] == kNone || partition.seedOfPiece[piece] != partition.seedOfPiece[first])
        return false;
    bool isSeparated = !std::ranges::equal(partition.cutCellsOf(piece), partition.cutCellsOf(first));
    forEachEdge(partition, piece, [&](std::uint32_t, std::uint32_t, std::uint32_t neighbour) {
        isSeparated = isSeparated || (neighbour >= first && neighbour < piece);
    });
    return !isSeparated;
}

/// Returns a colour for each piece: the same for the pieces of a seed that no cut separates, different from its
/// neighbours' if the palette is large enough.
std::vector<std::size_t> pieceColours(const Partition& partition) {
    constexpr std::size_t kUncoloured = kCellColours.size();
    std::vector<std::size_t> colours(partition.pieceCount(), kUncoloured);
    for (std::uint32_t first = 0, end = 0; first < partition.pieceCount(); first = end) {
        end = first + 1;
        while (end < partition.pieceCount() && hasSameColour(partition, first, end)) ++end;
        std::array<bool, kCellColours.size() + 1> isTaken{};
        const std::uint32_t firstCorner = partition.cornersOfRing[partition.ringsOfPiece[first]];
        const std::uint32_t endCorner = partition.cornersOfRing[partition.ringsOfPiece[end]];
        for (std::uint32_t corner = firstCorner; corner < endCorner; ++corner) {
            if (partition.neighbours[corner] != kNone) isTaken[colours[partition.neighbours[corner]]] = true;
        }
        std::size_t colour = splitmix64(keyOf(partition, first)) % kCellColours.size();
        for (std::size_t tried = 0; tried < kCellColours.size() && isTaken[colour]; ++tried) {
            colour = (colour + 1) % kCellColours.size();
        }
        std::fill(colours.begin() + first, colours.begin() + end, colour);
    }
    return colours;
}

void drawCells(SvgWriter& svg, const Frame& frame, const Partition& partition) {
    const std::vector<std::size_t> colours = pieceColours(partition);
    svg << "<g stroke=\"#8a7f72\" stroke-width=\"1\" stroke-linejoin=\"round\" fill-rule=\"evenodd\">\n";
    for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
        svg << "<path fill=\"" << kCellColours[colours[piece]] << "\" d=\"";
        appendPolygon(svg, frame, pieceOutline(partition, piece), partition.origin);
        svg << "\"/>\n";
    }
    svg << "</g>\n";
}

void drawTriangles(SvgWriter& svg, const Frame& frame, const PatternPanel& panel) {
    std::vector<std::array<std::uint32_t, 2>> edges;
    for (const auto& triangle : panel.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(triangle[k], triangle[(k + 1) % 3]);
            edges.push_back({low, high});
        }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    svg << "<path fill=\"none\" stroke=\"#3d6fb4\" stroke-opacity=\"0.55\" stroke-width=\"0.8\" d=\"";
    for (const auto& edge : edges) {
        svg << 'M' << frame.pixels(panel.seeds[edge[0]]) << 'L' << frame.pixels(panel.seeds[edge[1]]);
    }
    svg << "\"/>\n";
}

/// Returns a radius so small that many seeds do not hide their cells.
double dotRadius(const Frame& frame, std::size_t seedCount) {
    const Vec2 size = frame.size();
    return std::clamp(0.07 * std::sqrt(size.x * size.y / static_cast<double>(seedCount)), 0.6, 3.2);
}

void drawSeeds(SvgWriter& svg, const Frame& frame, const PatternPanel& panel) {
    const double radius = dotRadius(frame, panel.seeds.size());
    svg << "<g fill=\"#b3261e\" stroke=\"#b3261e\" stroke-width=\"0.8\">\n";
    for (std::size_t seed = 0; seed < panel.seeds.size(); ++seed) {
        const Vec2 at = frame.pixels(panel.seeds[seed]);
        svg << "<circle cx=\"" << at.x << "\" cy=\"" << at.y << "\" r=\"" << radius;
        svg << (panel.partition.pieceOfSeed[seed] == kNone ? "\" fill=\"none\"/>\n" : "\"/>\n");
    }
    svg << "</g>\n";
}

/// A bar of 1, 2 or 5 times a power of ten, at most half as wide as the outline.
void drawScaleBar(SvgWriter& svg, const Frame& frame) {
    const double maxLength = frame.bounds.size().x / 2.0;
    double unit = 1.0;
    while (unit > maxLength) unit /= 10.0;
    while (unit * 10.0 <= maxLength) unit *= 10.0;
    const double length = unit * (5.0 * unit <= maxLength ? 5.0 : 2.0 * unit <= maxLength ? 2.0 : 1.0);
    const Vec2 start(frame.corner.x, frame.corner.y + frame.size().y + kBleed + 10.0);
    const double end = start.x + length * frame.scale;
    svg << "<path fill=\"none\" stroke=\"#555\" d=\"M" << start << "v6H" << end << "v-6\"/>\n";
    svg << "<text x=\"" << end + 6.0 << "\" y=\"" << start.y + 9.0 << "\" font-size=\"11\" fill=\"#555\">";
    svg << numberText(length) << " m</text>\n";
}

void drawTitle(SvgWriter& svg, const Frame& frame, double top, const PatternPanel& panel) {
    const Vec2 size = frame.bounds.size();
    const auto cells = static_cast<std::size_t>(
        std::ranges::count_if(panel.partition.pieceOfSeed, [](std::uint32_t piece) { return piece != kNone; }));
    svg << "<text x=\"" << frame.corner.x << "\" y=\"" << top << "\" font-size=\"17\" font-weight=\"bold\">";
    svg << escapedXml(panel.title) << "</text>\n";
    svg << "<text x=\"" << frame.corner.x << "\" y=\"" << top + 19.0 << "\" font-size=\"12\" fill=\"#555\">";
    const bool isCut = !panel.partition.cutLayers.empty() || (cells == 0 && panel.partition.pieceCount() > 1);
    if (!isCut || !panel.seeds.empty()) svg << countText(panel.seeds.size(), "seed", "seeds") << ", ";
    svg << (isCut ? countText(panel.partition.pieceCount(), "piece", "pieces") : countText(cells, "cell", "cells"))
        << "; ";
    svg << lengthText(size.x) << " × " << lengthText(size.y);
    if (panel.section.empty()) svg << " × " << lengthText(panel.depth);
    svg << " m" << (panel.section.empty() ? "" : " at " + escapedXml(panel.section)) << "</text>\n";
}

void drawPanel(SvgWriter& svg, const Frame& frame, std::size_t index, const PatternPanel& panel,
               const PatternSvgOptions& options) {
    drawTitle(svg, frame, frame.corner.y - kBleed - kTitleHeight + 20.0, panel);
    const Vec2 corner = frame.corner - Vec2(kBleed);
    const Vec2 size = frame.size() + Vec2(2.0 * kBleed);
    const std::string clip = "panel" + std::to_string(index);
    svg << "<defs><clipPath id=\"" << clip << "\"><rect x=\"" << corner.x << "\" y=\"" << corner.y << "\" width=\""
        << size.x;
    svg << "\" height=\"" << size.y << "\"/></clipPath></defs>\n<g clip-path=\"url(#" << clip << ")\">\n";
    if (options.cells) drawCells(svg, frame, panel.partition);
    if (options.triangles && panel.section.empty()) drawTriangles(svg, frame, panel);
    svg << "<path fill=\"none\" stroke=\"#3a342d\" stroke-width=\"2\" stroke-linejoin=\"round\" d=\"";
    for (const Polygon& outline : panel.outlines) appendPolygon(svg, frame, outline, Vec2(0.0));
    svg << "\"/>\n";
    if (options.seeds && !panel.seeds.empty()) drawSeeds(svg, frame, panel);
    svg << "</g>\n";
    drawScaleBar(svg, frame);
}

bool hasSeedWithoutCell(const PatternPanel& panel) {
    return std::ranges::find(panel.partition.pieceOfSeed, kNone) != panel.partition.pieceOfSeed.end();
}

void drawLegend(SvgWriter& svg, double top, std::span<const PatternPanel> panels, const PatternSvgOptions& options) {
    double left = kSpace + kBleed;
    const auto entry = [&](std::string_view symbol, std::string_view text, double width) {
        svg << "<g transform=\"translate(" << left << ' ' << top << ")\">" << symbol << "<text x=\"26\" y=\"4\">"
            << text;
        svg << "</text></g>\n";
        left += width;
    };
    svg << "<g font-size=\"12\" fill=\"#333\">\n";
    entry("<path fill=\"none\" stroke=\"#3a342d\" stroke-width=\"2\" d=\"M0 0H18\"/>", "outline", 96.0);
    if (options.seeds) {
        entry("<circle cx=\"9\" r=\"3.2\" fill=\"#b3261e\"/>", "seed", 80.0);
    }
    if (options.seeds && std::ranges::any_of(panels, hasSeedWithoutCell)) {
        entry("<circle cx=\"9\" r=\"3.2\" fill=\"none\" stroke=\"#b3261e\"/>", "seed without a cell", 156.0);
    }
    const bool isAnyPrism = std::ranges::any_of(panels, [](const PatternPanel& p) { return p.section.empty(); });
    if (options.triangles && isAnyPrism) {
        entry("<path stroke=\"#3d6fb4\" d=\"M0 0H18\"/>", "Delaunay triangulation", 176.0);
    }
    if (options.cells) {
        entry("<rect y=\"-6\" width=\"18\" height=\"12\" fill=\"#cfe3d4\" stroke=\"#8a7f72\"/>", "Voronoi cell", 120.0);
    }
    svg << "</g>\n";
}

}  // namespace

std::string patternSvg(std::span<const PatternPanel> panels, const PatternSvgOptions& options) {
    // The legend needs two columns; a single panel takes both.
    const double columnsOfPanel = panels.size() == 1 ? 2.0 : 1.0;
    std::vector<Frame> frames;
    for (const PatternPanel& panel : panels) frames.push_back(frameOf(panel, columnsOfPanel));
    const double legendTop = arrange(frames);
    const auto columns = static_cast<double>(std::clamp<std::size_t>(panels.size(), 2, kMaxColumns));
    const Vec2 size(kSpace + columns * (kColumnWidth + kSpace), legendTop + kLegendHeight + kSpace / 2.0);

    SvgWriter svg;
    svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << size.x << "\" height=\"" << size.y;
    svg << "\" viewBox=\"0 0 " << size << "\" font-family=\"sans-serif\">\n";
    svg << "<rect width=\"" << size.x << "\" height=\"" << size.y << "\" fill=\"#fffdf9\"/>\n";
    for (std::size_t i = 0; i < panels.size(); ++i) drawPanel(svg, frames[i], i, panels[i], options);
    drawLegend(svg, legendTop, panels, options);
    svg << "</svg>\n";
    return std::move(svg).text();
}

}  // namespace rubble
