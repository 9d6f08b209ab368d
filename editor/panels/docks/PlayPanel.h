#pragma once

#include "editor/panels/models/BreakModel.h"
#include "editor/play/PlayController.h"

#include <QElapsedTimer>
#include <QWidget>

class QLabel;
class QTreeView;

namespace rubble {

class StepGraph;

/// The dock with statistics of the simulation: the time per step, and a list of breaks. Activating a break emits
/// jumpRequested().
class PlayPanel : public QWidget {
    Q_OBJECT
public:
    explicit PlayPanel(PlayController& controller, QWidget* parent = nullptr);

signals:
    /// The user asks to see a break at this position.
    void jumpRequested(const rubble::Vec3& position);

private:
    void widenColumns();
    void refreshGraph();
    void refreshBreaks();

    PlayController& m_controller;
    StepGraph* m_graph;
    BreakModel* m_model;
    QTreeView* m_view;
    QLabel* m_summary;
    QElapsedTimer m_lastPaint;
};

}  // namespace rubble
