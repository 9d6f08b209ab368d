#pragma once

#include <QList>
#include <QWidget>

class QToolButton;
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
    void demoRequested(const QString& path);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    QWidget* startColumn();
    QWidget* recentColumn();
    QWidget* exampleRow();
    void fillRecent();
    void showPictures();

    RecentFiles& m_recentFiles;
    QVBoxLayout* m_recentRows = nullptr;
    QList<QToolButton*> m_examples;  // each knows the name of its picture
};

}  // namespace rubble
