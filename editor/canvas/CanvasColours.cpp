#include "editor/canvas/CanvasColours.h"

#include <array>

namespace rubble {

namespace {

bool isDark(const QPalette& palette) {
    return palette.color(QPalette::WindowText).lightness() > palette.color(QPalette::Window).lightness();
}

}  // namespace

CanvasColours canvasColours(const QPalette& palette) {
    const QColor accent = palette.color(QPalette::Highlight);
    if (isDark(palette)) {
        return {.background = "#202225",
                .fineGrid = "#282a2e",
                .grid = "#34373c",
                .axis = "#555a62",
                .label = "#969ba3",
                .cell = "#3b3f46",
                .cellEdge = "#17181a",
                .outline = "#f1eee8",
                .halo = "#17181a",
                .triangle = "#1c3f8f",
                .circle = "#7c3aed",
                .wholeVoronoi = "#c9a227",
                .edgeOnScale = QColor(255, 252, 245, 130),
                .triangleOnScale = "#7fa8ff",
                .accent = accent,
                .hover = "#ffffff",
                .fault = "#ff5a4f",
                .measure = "#4cc2ff",
                .panel = "#2b2d31",
                .panelEdge = "#44474d",
                .text = "#e4e2de"};
    }
    return {.background = "#faf9f7",
            .fineGrid = "#f0eeea",
            .grid = "#e0ddd7",
            .axis = "#b5b0a8",
            .label = "#6f6a63",
            .cell = "#ece8e1",
            .cellEdge = "#6d665d",
            .outline = "#2c2823",
            .halo = "#ffffff",
            .triangle = "#1f4fb0",
            .circle = "#7c3aed",
            .wholeVoronoi = "#a1780a",
            .edgeOnScale = QColor(255, 252, 245, 130),
            .triangleOnScale = "#7fa8ff",
            .accent = accent,
            .hover = "#1a1714",
            .fault = "#c8201a",
            .measure = "#0b63b8",
            .panel = "#ffffff",
            .panelEdge = "#cfcac2",
            .text = "#232323"};
}

QColor layerColour(std::size_t layer) {
    static const std::array<QColor, 6> kColours = {"#a61c1c", "#174ea6", "#0b6b3a", "#6a1b9a", "#00606b", "#6d4100"};
    return kColours[layer % kColours.size()];
}

}  // namespace rubble
