#pragma once

#include "editor/canvas/tools/CanvasTool.h"

#include <memory>
#include <vector>

namespace rubble {

class BondBrushTool;
class BrushTool;
class CrackLineTool;
class MeasureTool;
class OutlineTool;
class SeedTool;

enum class CanvasToolKind {
    Outline,
    Seeds,
    PlaceSeeds,
    CrackLines,
    Brush,
    Measure,
    AnchorBrush,  // this and the following: of assets that break as bonded
    StrengthBrush,
    NeverBreaksBrush,
};
bool isBondBrush(CanvasToolKind kind);
/// Whether it shows a brush at the pointer.
bool isBrush(CanvasToolKind kind);

/// The tools of a canvas.
class CanvasTools {
public:
    explicit CanvasTools(const CanvasState& state);
    ~CanvasTools();

    OutlineTool& outline() const { return *m_outline; }
    SeedTool& seeds() const { return *m_seeds; }
    CrackLineTool& crackLines() const { return *m_crackLines; }
    BrushTool& brush() const { return *m_brush; }
    BondBrushTool& bondBrush() const { return *m_bondBrush; }
    MeasureTool& measure() const { return *m_measure; }
    std::vector<CanvasTool*> all() const;

    /// The tool of a kind, prepared as such: some tools are of several kinds.
    CanvasTool& prepare(CanvasToolKind kind);

private:
    const CanvasState& m_state;
    std::unique_ptr<OutlineTool> m_outline;
    std::unique_ptr<SeedTool> m_seeds;
    std::unique_ptr<CrackLineTool> m_crackLines;
    std::unique_ptr<BrushTool> m_brush;
    std::unique_ptr<BondBrushTool> m_bondBrush;
    std::unique_ptr<MeasureTool> m_measure;
};

}  // namespace rubble
