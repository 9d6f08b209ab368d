#pragma once

#include <QTextBrowser>

namespace rubble {

/// A browser for Markdown pages with spacing around headings and in tables, and pictures scaled to the width of the
/// text.
class ManualPage : public QTextBrowser {
    Q_OBJECT
public:
    explicit ManualPage(QWidget* parent = nullptr);

    QVariant loadResource(int type, const QUrl& name) override;

protected:
    void changeEvent(QEvent* event) override;

private:
    void formatPage();
};

}  // namespace rubble
