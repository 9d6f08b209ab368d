#pragma once

#include <QWidget>

class QVBoxLayout;

namespace rubble {

class RecentFiles;

/// The page of a window without a project: creating, opening and importing, the recent projects and the examples.
class StartPage : public QWidget {
    Q_OBJECT
public:
    explicit StartPage(RecentFiles& recentFiles, QWidget* parent = nullptr);

signals:
    void newProjectRequested();
    void openRequested();
    void importRequested();
    void recentRequested(const QString& path);
    void exampleRequested(const QString& path);

private:
    QWidget* startColumn();
    QWidget* recentColumn();
    QWidget* exampleRow();
    void fillRecent();

    RecentFiles& m_recentFiles;
    QVBoxLayout* m_recentRows = nullptr;
};

}  // namespace rubble
