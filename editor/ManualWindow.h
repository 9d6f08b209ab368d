#pragma once

#include <QMainWindow>

class QTextBrowser;

namespace rubble {

/// The manual: Markdown pages with pictures from a folder, with links, a way back and a search on the page.
class ManualWindow : public QMainWindow {
    Q_OBJECT
public:
    ManualWindow(const QString& folder, const QPalette& palette);

private:
    void find(const QString& words);
    QTextBrowser* m_page;
};

}  // namespace rubble
