#pragma once

#include <QMainWindow>

class QTextBrowser;

namespace rubble {

/// Shows the manual: the Markdown pages of a folder, with Back, Contents and a search on the page.
class ManualWindow : public QMainWindow {
    Q_OBJECT
public:
    explicit ManualWindow(const QString& folder);

private:
    void findNext(const QString& text);
    QTextBrowser* m_page;
};

}  // namespace rubble
