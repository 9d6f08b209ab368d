#pragma once

#include <QWidget>

class QVBoxLayout;

namespace rubble {

class RecentFiles;

/// What a window shows before there is a project: new and open, what was opened last, and examples with their pictures.
class StartPage : public QWidget {
    Q_OBJECT
public:
    explicit StartPage(RecentFiles& recent, QWidget* parent = nullptr);

signals:
    void newChosen();
    void openChosen();
    void importChosen();
    void recentChosen(const QString& path);
    void exampleChosen(const QString& path);

private:
    QWidget* beginnings();
    QWidget* examples();
    void fillRecent();

    RecentFiles& m_recent;
    QVBoxLayout* m_recentRows = nullptr;
};

}  // namespace rubble
