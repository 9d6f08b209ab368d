#pragma once

#include "editor/canvas/widget/CanvasContentsUpdater.h"
#include "editor/canvas/widget/CanvasTools.h"

#include <QWidget>

class QAccessibleInterface;

namespace rubble {

class Breadcrumb;
class SectionBar;
class Sections;

/// Shows the pattern of the active asset, or of its entered fragment, in the plane, with tools to edit outline, seeds
/// and cracks. Only what changed is repainted. While seeds are dragged, the cells around them are updated at once; the
/// whole pattern follows when it is baked.
class PatternCanvas : public QWidget {
    Q_OBJECT
public:
    /// `bondPainter`: of its document and selection.
    PatternCanvas(Document& document, Selection& selection, const Bakes& bakes, BondPainter& bondPainter,
                  QWidget* parent = nullptr);
    ~PatternCanvas() override;

    /// Shows the bar that moves the sections of meshes.
    void setSections(Sections& sections);

    CanvasToolKind toolKind() const { return m_toolKind; }
    void setTool(CanvasToolKind kind);
    OutlineTool& outlineTool() { return m_tools.outline(); }
    SeedTool& seedTool() { return m_tools.seeds(); }
    CrackLineTool& crackLineTool() { return m_tools.crackLines(); }
    BrushTool& brushTool() { return m_tools.brush(); }
    BondBrushTool& bondBrushTool() { return m_tools.bondBrush(); }
    MeasureTool& measureTool() { return m_tools.measure(); }

    const CanvasOverlays& overlays() const { return contents().overlays; }
    void setOverlays(const CanvasOverlays& overlays);
    bool isSnapping() const { return m_state.isSnapping; }
    void setSnapping(bool isSnapping) { m_state.isSnapping = isSnapping; }
    /// The units of the rulers and of displayed quantities.
    void setUnits(const Units& units);
    const CanvasView& view() const { return m_state.view; }
    void setView(const CanvasView& view);
    /// Fits the whole outline into the view; resizing keeps it fitted until the user moves the view.
    void fit();
    /// In pixels; empty without a legend.
    QRectF legendArea() const;
    void zoomBy(double factor);
    /// Frames the cells of the selected seeds, and `point` if given, m.
    void frameSelected(std::optional<Vec2> point = std::nullopt);

    /// Shows the changes since an earlier state in place of the cells' colours; null shows the colours again.
    void setCompared(std::shared_ptr<const ComparedAsset> compared);

    /// The context menu's actions for selected fragments, in addition to those of the tool.
    void setFragmentActions(const QList<QAction*>& actions) { m_fragmentActions = actions; }
    /// Actions whose shortcuts precede those of the window while the canvas has the focus.
    void setPrecedingActions(const QList<QAction*>& actions) { m_precedingActions = actions; }

    /// Returns a picture of the canvas without what follows the pointer. It shows all that the widget does, and more of
    /// the plane where the proportions differ; lines and texts grow with its size.
    QImage picture(QSize pixels);

    /// The current tool's hint for the status bar.
    QString hint() const;
    /// The last baked pattern; may be null.
    const DrawablePattern* displayedPattern() const { return contents().pattern.get(); }
    /// The asset whose cells are shown; null if there are none.
    const Asset* displayedAsset() const { return contents().asset(); }
    QSize sizeHint() const override { return {800, 600}; }
    QSize minimumSizeHint() const override { return {160, 120}; }

signals:
    /// A message for the status bar.
    void statusMessage(const QString& message);
    void hintChanged(const QString& hint);
    /// The position of the pointer, m.
    void pointerMoved(double x, double y);
    void pointerLeft();
    void overlaysChanged();
    void toolKindChanged(rubble::CanvasToolKind kind);
    /// Escape was pressed while changes were shown and no tool was active.
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
    const CanvasContents& contents() const { return m_updater.contents(); }
    void applyChanges(const Changes& changes);
    void refreshAsset();
    void refreshEnteredFragment();
    void saveView();
    void refreshFragment();
    void refreshSectionBar();
    void reportOwnPattern(const Changes& changes);
    static QAccessibleInterface* makeAccessible(const QString& className, QObject* object);
    void reportAccessible(int event);
    void updateTool();
    void release(const CanvasPointer& pointer);
    void endMissedRelease(const QMouseEvent& event);
    CanvasPointer pointerAt(QPointF pixels, Qt::KeyboardModifiers modifiers) const;
    void setPointer(const CanvasPointer& pointer);
    void updatePointer();
    void updateHovered();

    void refit();
    void paintOverlays(QPainter& painter) const;
    void paintHighlights(QPainter& painter) const;
    bool showsFragmentLabel() const;

    CanvasState m_state;
    CanvasContentsUpdater m_updater;
    QList<QAction*> m_fragmentActions;
    QList<QAction*> m_precedingActions;
    Breadcrumb* m_breadcrumb;
    SectionBar* m_sectionBar = nullptr;
    FragmentPath m_displayedFragment;  // empty: the whole asset
    struct SavedView {
        FragmentPath fragment;
        CanvasView view;
        bool isFitted;
    };
    std::vector<SavedView> m_savedViews;  // of the ancestors of m_displayedFragment
    bool m_hasOwnPattern = false;         // the entered fragment
    CanvasColours m_colours;
    CanvasTools m_tools;
    CanvasToolKind m_toolKind = CanvasToolKind::Seeds;
    CanvasTool* m_tool = nullptr;  // of m_toolKind

    bool m_isFitted = true;           // until the user moves the view
    bool m_isPatternAwaited = false;  // and with it the legend, beside which the asset is fitted
    std::optional<CanvasPointer> m_pointer;
    std::uint32_t m_hovered = kNone;  // piece
    std::optional<QPointF> m_panFrom;
    Qt::MouseButton m_panButton = Qt::NoButton;
    bool m_isSpaceHeld = false;
    bool m_isPressed = false;  // the left button, passed to the tool
};

}  // namespace rubble
