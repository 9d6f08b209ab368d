#pragma once

#include "editor/panels/BreakModel.h"
#include "editor/play/PlayController.h"

#include <QElapsedTimer>
#include <QWidget>

class QLabel;
class QTreeView;

namespace rubble {

class StepGraph;

/// The dock with what a play tells: how long steps take, and what broke. Enter or a double click goes to a break.
class PlayPanel : public QWidget {
    Q_OBJECT
public:
    explicit PlayPanel(PlayController& controller, QWidget* parent = nullptr);

signals:
    /// A break is to be looked at: its place is.
    void jumpRequested(const rubble::Vec3& place);

private:
    void widenColumns();
    void takeFrame();
    void takeBreaks();

    PlayController& m_controller;
    StepGraph* m_graph;
    BreakModel* m_model;
    QTreeView* m_view;
    QLabel* m_summary;
    QElapsedTimer m_lastPaint;
};

}  // namespace rubble
