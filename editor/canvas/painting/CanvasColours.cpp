#include "editor/canvas/painting/CanvasColours.h"

#include "editor/widgets/ColourScheme.h"

#include <array>

namespace rubble {

CanvasColours canvasColours(const QPalette& palette) {
    const bool hasDark = isDark(palette);
    const auto either = [&](const char* light, const char* dark) { return QColor(hasDark ? dark : light); };
    return {.background = either("#faf9f7", "#202225"),
            .minorGrid = either("#f0eeea", "#282a2e"),
            .grid = either("#e0ddd7", "#34373c"),
            .axis = either("#b5b0a8", "#555a62"),
            .label = either("#6f6a63", "#969ba3"),
            .cell = either("#ece8e1", "#3b3f46"),
            .cellEdge = either("#6d665d", "#17181a"),
            .outline = either("#2c2823", "#f1eee8"),
            .halo = either("#ffffff", "#17181a"),
            .triangle = either("#1f4fb0", "#1c3f8f"),
            .circle = "#7c3aed",
            .wholeVoronoi = either("#a1780a", "#c9a227"),
            .bond = either("#1f2a44", "#f4f1ea"),
            .edgeOnScale = QColor(255, 252, 245, 130),
            .triangleOnScale = "#7fa8ff",
            .anchored = either("#00646e", "#3fd6e4"),
            .neverBreaks = either("#6a1b9a", "#d3a5ff"),
            .weakBond = either("#c2410c", "#ff9550"),
            .neutralBond = either("#7b756d", "#6f747c"),
            .strongBond = either("#1d4ed8", "#7fb0ff"),
            .added = either("#0a5fa8", "#5ab4f0"),
            .gone = either("#b94a00", "#f29b4b"),
            .moved = either("#8a3a78", "#e3a3d2"),
            .reshaped = either("#6b6200", "#e2d84a"),
            .accent = palette.color(QPalette::Highlight),
            .hover = either("#1a1714", "#ffffff"),
            .fault = either("#c8201a", "#ff5a4f"),
            .measure = either("#0b63b8", "#4cc2ff"),
            .panel = either("#ffffff", "#2b2d31"),
            .panelEdge = either("#cfcac2", "#44474d"),
            .text = either("#232323", "#e4e2de")};
}

QColor layerColour(std::size_t layer) {
    static const std::array<QColor, 6> kColours = {"#a61c1c", "#174ea6", "#0b6b3a", "#6a1b9a", "#00606b", "#6d4100"};
    return kColours[layer % kColours.size()];
}

}  // namespace rubble
