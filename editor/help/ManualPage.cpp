#include "editor/help/ManualPage.h"

#include <QEvent>
#include <QImage>
#include <QScrollBar>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextTable>

#include <algorithm>

namespace rubble {

namespace {

constexpr int kMaxPictureWidth = 780;  // pixels
constexpr double kPageMargin = 28.0;   // pixels, as the next two
constexpr double kCellPadding = 5.0;
constexpr double kHeadingMargin = 20.0;
constexpr double kLineHeightPercent = 125.0;

/// Returns the tables of a page, which are never nested.
QList<QTextTable*> tablesOf(const QTextDocument& document) {
    QList<QTextTable*> tables;
    for (QTextFrame* frame : document.rootFrame()->childFrames()) {
        if (auto* table = qobject_cast<QTextTable*>(frame)) tables.append(table);
    }
    return tables;
}

void formatTable(QTextTable& table, const QPalette& palette) {
    QTextTableFormat format = table.format();
    format.setBorder(1.0);
    format.setBorderCollapse(true);
    format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
    format.setBorderBrush(palette.mid());
    format.setCellPadding(kCellPadding);
    format.setCellSpacing(0.0);
    format.setTopMargin(kCellPadding);
    format.setBottomMargin(2.0 * kCellPadding);
    table.setFormat(format);
    for (int column = 0; column < table.columns(); ++column) {
        QTextTableCell cell = table.cellAt(0, column);
        QTextTableCellFormat shade = cell.format().toTableCellFormat();
        shade.setBackground(palette.alternateBase());
        cell.setFormat(shade);
    }
}

}  // namespace

ManualPage::ManualPage(QWidget* parent) : QTextBrowser(parent) {
    document()->setDocumentMargin(kPageMargin);
    connect(this, &QTextBrowser::sourceChanged, this, &ManualPage::formatPage);
}

QVariant ManualPage::loadResource(int type, const QUrl& name) {
    const QVariant resource = QTextBrowser::loadResource(type, name);
    if (type != QTextDocument::ImageResource) return resource;
    const QImage picture = QImage::fromData(resource.toByteArray());
    if (picture.width() <= kMaxPictureWidth) return resource;
    const double ratio = std::min(devicePixelRatioF(), static_cast<double>(picture.width()) / kMaxPictureWidth);
    QImage scaled = picture.scaledToWidth(qRound(kMaxPictureWidth * ratio), Qt::SmoothTransformation);
    scaled.setDevicePixelRatio(ratio);
    return scaled;
}

/// Links and tables keep the colours that they were read with.
void ManualPage::changeEvent(QEvent* event) {
    QTextBrowser::changeEvent(event);
    if (event->type() != QEvent::PaletteChange || source().isEmpty()) return;
    const int scrolled = verticalScrollBar()->value();
    reload();
    formatPage();
    verticalScrollBar()->setValue(scrolled);
}

void ManualPage::formatPage() {
    QTextCursor cursor(document());
    cursor.beginEditBlock();
    for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
        QTextBlockFormat format = block.blockFormat();
        const bool isPicture = block.text().contains(QChar::ObjectReplacementCharacter);
        if (!isPicture) format.setLineHeight(kLineHeightPercent, QTextBlockFormat::ProportionalHeight);
        if (format.headingLevel() > 1) format.setTopMargin(kHeadingMargin);
        cursor.setPosition(block.position());
        cursor.setBlockFormat(format);
    }
    cursor.endEditBlock();
    for (QTextTable* table : tablesOf(*document())) formatTable(*table, palette());
}

}  // namespace rubble

#include "moc_ManualPage.cpp"
