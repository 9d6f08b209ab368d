#pragma once

#include "editor/canvas/CanvasPicture.h"
#include "editor/canvas/CanvasTool.h"

#include <QWidget>

namespace rubble {

class BrushTool;
class MeasureTool;
class OutlineTool;
class PlaceTrail;
class SeedTool;
class StrokeTool;

enum class CanvasToolKind { Outline, Seeds, Strokes, Brush, Measure };

/// Shows the pattern of the asset at hand, or of a fragment of it that is broken again, in the plane, and is where it is drawn: outline,
/// seeds and what they make, with tools to change them. What was painted is kept; only what changed is painted again. While seeds are dragged, the cells
/// around them are there at once; the whole pattern follows when it was baked.
class PatternCanvas : public QWidget {
    Q_OBJECT
public:
    PatternCanvas(Document& document, Selection& selection, const Bakes& bakes, QWidget* parent = nullptr);
    ~PatternCanvas() override;

    CanvasToolKind toolKind() const { return m_toolKind; }
    void setTool(CanvasToolKind kind);
    OutlineTool& outlineTool() { return *m_outlineTool; }
    SeedTool& seedTool() { return *m_seedTool; }
    StrokeTool& strokeTool() { return *m_strokeTool; }
    BrushTool& brushTool() { return *m_brushTool; }
    MeasureTool& measureTool() { return *m_measureTool; }

    const CanvasLayers& layers() const { return m_contents.layers; }
    void setLayers(const CanvasLayers& layers);
    bool isSnapping() const { return m_state.isSnapping; }
    void setSnapping(bool isSnapping) { m_state.isSnapping = isSnapping; }
    const CanvasView& view() const { return m_state.view; }
    void setView(const CanvasView& view);
    /// Shows all of the outline that one is inside; it stays so until the view is moved by hand.
    void fit();
    void zoomBy(double factor);
    /// Brings the cells of the chosen seeds close, with a place that may lie elsewhere.
    void frameChosen(std::optional<Vec2> place = std::nullopt);

    /// Shows what became of pieces since an earlier state, in place of the cells' colours; null: no more.
    void setCompared(std::shared_ptr<const ComparedAsset> compared);

    /// What its menu offers for chosen fragments, beside what the tool at hand does.
    void setPieceActions(const QList<QAction*>& actions) { m_pieceActions = actions; }

    /// What can be done now, for a status bar.
    QString hint() const;
    /// What was baked last; null where nothing was.
    const ShownPattern* shownPattern() const { return m_contents.pattern.get(); }
    /// The state of the asset whose cells are shown; null where none are.
    const Asset* shownAsset() const { return m_contents.asset(); }
    QSize sizeHint() const override { return {800, 600}; }
    QSize minimumSizeHint() const override { return {160, 120}; }

signals:
    /// Something to tell the user.
    void said(const QString& sentence);
    void hintChanged(const QString& hint);
    /// The pointer stands there, m.
    void pointed(double x, double y);
    void pointerLeft();
    void layersChanged();
    void toolKindChanged(rubble::CanvasToolKind kind);
    /// Escape was pressed while changes were shown and nothing else was going on.
    void comparisonDismissed();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void takeChanges(const Changes& changes);
    void takeAsset();
    void takeInside();
    void keepView();
    void takeFragment();
    void takePattern();
    void takeBake();
    void takeSurroundings();
    void takeComparison();
    void takeMaterial();
    void tellOfOwnPattern(const Changes& changes);
    ShownPattern::Range scale() const;
    void findMoved();
    void takeMoves();
    bool isLocal() const;
    Box2 movedBox(const MovedPart* part) const;
    void toolChanged();
    void addPlaces(QMenu& menu, const std::optional<FragmentPath>& broken);
    CanvasPointer pointerAt(QPointF pixels, Qt::KeyboardModifiers modifiers) const;
    void point(const CanvasPointer& pointer);
    void pointAgain();

    void repaintAll();
    void repaintPart(const Box2& part);
    void paintMarks(QPainter& painter) const;
    bool isTellingOfPiece() const;
    QString sentenceInstead() const;

    CanvasState m_state;
    CanvasContents m_contents;
    QList<QAction*> m_pieceActions;
    PlaceTrail* m_trail;
    FragmentPath m_place;  // that is shown
    struct KeptView {
        FragmentPath place;
        CanvasView view;
        bool isFitted;
    };
    std::vector<KeptView> m_keptViews;                // of the places that one went through to it
    bool m_hasOwnPattern = false;                     // the fragment that one is inside
    std::shared_ptr<const ComparedAsset> m_compared;  // shown of the whole; null: none
    std::unique_ptr<MovedCells> m_movedCells;         // of the pattern in m_contents
    CanvasColours m_colours;
    std::unique_ptr<OutlineTool> m_outlineTool;
    std::unique_ptr<SeedTool> m_seedTool;
    std::unique_ptr<StrokeTool> m_strokeTool;
    std::unique_ptr<BrushTool> m_brushTool;
    std::unique_ptr<MeasureTool> m_measureTool;
    CanvasToolKind m_toolKind = CanvasToolKind::Seeds;
    CanvasTool* m_tool = nullptr;  // the one of that kind

    CanvasPicture m_picture;
    bool m_isFitted = true;  // until the view is moved by hand
    std::optional<CanvasPointer> m_pointer;
    std::uint32_t m_hovered = kNone;  // piece
    std::optional<QPointF> m_panFrom;
    bool m_hasSpace = false;
    bool m_isPressed = false;  // the left button, on the tool
};

}  // namespace rubble
