#pragma once

#include "editor/panels/models/ImpactModel.h"
#include "editor/play/PlayController.h"

#include <QElapsedTimer>
#include <QWidget>

class QLabel;
class QTreeView;

namespace rubble {

class StepGraph;

/// The dock with statistics of the simulation: the time per step, and a list of impacts. Activating one emits
/// jumpRequested().
class PlayPanel : public QWidget {
    Q_OBJECT
public:
    explicit PlayPanel(PlayController& controller, QWidget* parent = nullptr);

signals:
    /// The user asks to see an impact at this position.
    void jumpRequested(const rubble::Vec3& position);

private:
    void addContextMenu();
    void widenColumns();
    void refreshFrame();
    void refreshImpacts();
    void refreshSummary();

    PlayController& m_controller;
    StepGraph* m_graph;
    ImpactModel* m_model;
    QTreeView* m_view;
    QLabel* m_summary;
    QElapsedTimer m_lastPaint;
};

}  // namespace rubble
