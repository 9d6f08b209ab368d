#pragma once

#include "editor/document/Document.h"
#include "editor/panels/models/ImpactModel.h"
#include "editor/play/PlayController.h"

#include <QElapsedTimer>
#include <QWidget>

class QAction;
class QLabel;
class QTreeView;

namespace rubble {

class StepGraph;

/// The dock with statistics of the simulation: the time per step, and a list of impacts. Activating one emits
/// jumpRequested(); one can be made a strength requirement of its asset.
class PlayPanel : public QWidget {
    Q_OBJECT
public:
    PlayPanel(Document& document, PlayController& controller, QWidget* parent = nullptr);

signals:
    /// The user asks to see an impact at this position.
    void jumpRequested(const rubble::Vec3& position);
    void statusMessage(const QString& message);

private:
    QWidget* makeButtons();
    QAction* makeRequirementAction(const char* name, const QString& text, const QString& hint,
                                   RequirementOutcome outcome);
    /// The selected impact; null if none is, or its asset no longer exists.
    const ImpactRecord* selectedImpact() const;
    void addRequirement(RequirementOutcome outcome);
    void refreshActions();
    void addContextMenu();
    void widenColumns();
    void refreshFrame();
    void refreshImpacts();
    void refreshSummary();

    Document& m_document;
    PlayController& m_controller;
    QList<QAction*> m_actions;  // on the selected impact
    StepGraph* m_graph;
    ImpactModel* m_model;
    QTreeView* m_view;
    QLabel* m_summary;
    QElapsedTimer m_lastPaint;
};

}  // namespace rubble
