#pragma once

#include "core/play/analysis/ThresholdInterval.h"
#include "editor/document/Document.h"
#include "editor/panels/docks/EventTable.h"
#include "editor/play/PlayController.h"

#include <QElapsedTimer>
#include <QWidget>

class QAction;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace rubble {

class EventFilterBar;
class StepGraph;

/// The dock with statistics of the simulation: the time per step, and a list of events with a filter, which the
/// timeline follows. Activating an event emits jumpRequested(); an impact can be made a strength requirement of its
/// asset.
class PlayPanel : public QWidget {
    Q_OBJECT
public:
    PlayPanel(Document& document, PlayController& controller, QWidget* parent = nullptr);

    /// Adds a button for the actions that export all events and those shown.
    void setExportActions(QAction* all, QAction* shown);
    EventTable& events() { return *m_table; }

signals:
    /// The user asks to see an event at this position.
    void jumpRequested(const rubble::Vec3& position);
    void statusMessage(const QString& message);
    void refused(const QString& sentence);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* makeList();
    void makeRequirementActions();
    QAction* makeRequirementAction(const char* name, const QString& text, const QString& hint,
                                   RequirementOutcome outcome);
    /// How near the selected event came to breaking a body; null if it did not, or the asset no longer exists.
    const ImpactStrength* selectedStrength() const;
    void addRequirement(RequirementOutcome outcome);
    void refreshActions();
    void addContextMenu();
    void refreshMaterials();
    std::uint64_t displayedStep() const;
    void refreshFrame();
    void refreshEvents();
    void refreshSummary();
    QString countText() const;
    QString sumsText() const;

    Document& m_document;
    PlayController& m_controller;
    QList<QAction*> m_requirements;  // of the selected impact
    QAction* m_loop = nullptr;
    StepGraph* m_graph;
    EventFilterBar* m_filter;
    EventTable* m_table;
    QLabel* m_summary;
    QHBoxLayout* m_foot;  // the summary with the buttons
    QList<QToolButton*> m_requirementButtons;
    QElapsedTimer m_lastPaint;
};

}  // namespace rubble
