#pragma once

#include <QTextBrowser>

namespace rubble {

/// Shows pages of Markdown as a book does: room around headings and in tables, pictures no wider than the text.
class ManualPage : public QTextBrowser {
    Q_OBJECT
public:
    explicit ManualPage(QWidget* parent = nullptr);

    QVariant loadResource(int type, const QUrl& name) override;

private:
    void dress();
};

}  // namespace rubble
