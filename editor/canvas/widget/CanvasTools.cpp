#include "editor/canvas/widget/CanvasTools.h"

#include "editor/canvas/tools/BondBrushTool.h"
#include "editor/canvas/tools/BrushTool.h"
#include "editor/canvas/tools/CrackLineTool.h"
#include "editor/canvas/tools/MeasureTool.h"
#include "editor/canvas/tools/OutlineTool.h"
#include "editor/canvas/tools/SeedTool.h"

namespace rubble {

bool isBondBrush(CanvasToolKind kind) {
    return kind == CanvasToolKind::AnchorBrush || kind == CanvasToolKind::StrengthBrush ||
           kind == CanvasToolKind::NeverBreaksBrush;
}

bool isBrush(CanvasToolKind kind) { return kind == CanvasToolKind::Brush || isBondBrush(kind); }

CanvasTools::CanvasTools(const CanvasState& state)
    : m_state(state),
      m_outline(std::make_unique<OutlineTool>(state)),
      m_seeds(std::make_unique<SeedTool>(state)),
      m_crackLines(std::make_unique<CrackLineTool>(state)),
      m_brush(std::make_unique<BrushTool>(state)),
      m_bondBrush(std::make_unique<BondBrushTool>(state)),
      m_measure(std::make_unique<MeasureTool>(state)) {}

CanvasTools::~CanvasTools() = default;

std::vector<CanvasTool*> CanvasTools::all() const {
    return {m_outline.get(), m_seeds.get(), m_crackLines.get(), m_brush.get(), m_bondBrush.get(), m_measure.get()};
}

CanvasTool& CanvasTools::prepare(CanvasToolKind kind) {
    m_seeds->setPlacing(kind == CanvasToolKind::PlaceSeeds);
    m_state.bondPainter.setOn(isBondBrush(kind));
    switch (kind) {
        case CanvasToolKind::Outline: return *m_outline;
        case CanvasToolKind::Seeds:
        case CanvasToolKind::PlaceSeeds: break;
        case CanvasToolKind::CrackLines: return *m_crackLines;
        case CanvasToolKind::Brush: return *m_brush;
        case CanvasToolKind::Measure: return *m_measure;
        case CanvasToolKind::AnchorBrush: m_state.bondPainter.setBrush(BondBrush::Anchor); return *m_bondBrush;
        case CanvasToolKind::StrengthBrush: m_state.bondPainter.setBrush(BondBrush::Strength); return *m_bondBrush;
        case CanvasToolKind::NeverBreaksBrush:
            m_state.bondPainter.setBrush(BondBrush::NeverBreaks);
            return *m_bondBrush;
    }
    return *m_seeds;
}

}  // namespace rubble
