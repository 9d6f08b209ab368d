#include "tests/support/editor/TextFit.h"

#include <QAbstractScrollArea>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTextDocument>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace rubble::test {

namespace {

constexpr double kMinContrast = 4.5;

/// A text, and the size that it has and needs.
struct Fit {
    QString text;
    QSize room;
    QSize need;
};

int widthOf(const QWidget& widget, const QString& text) {
    return widget.fontMetrics().size(Qt::TextShowMnemonic, text).width();
}

std::optional<Fit> fitOf(const QLabel& label) {
    if (label.text().isEmpty()) return std::nullopt;
    const QSize room = label.size();
    if (label.wordWrap())
        return Fit{label.text(), room, {label.minimumSizeHint().width(), label.heightForWidth(room.width())}};
    if (Qt::mightBeRichText(label.text())) return Fit{label.text(), room, label.sizeHint()};
    const bool isElided = label.text().contains(u'…') && !label.toolTip().isEmpty();
    if (isElided) return std::nullopt;
    return Fit{label.text(), label.contentsRect().size(), {widthOf(label, label.text()), 0}};
}

std::optional<Fit> fitOf(const QAbstractButton& button) {
    if (button.text().isEmpty()) return std::nullopt;
    if (const auto* tool = qobject_cast<const QToolButton*>(&button)) {
        const bool hasText = tool->icon().isNull() || tool->toolButtonStyle() != Qt::ToolButtonIconOnly;
        if (!hasText) return std::nullopt;
    }
    return Fit{button.text(), button.size(), {button.minimumSizeHint().width(), 0}};
}

std::optional<Fit> fitOf(const QLineEdit& line) {
    const QString text = line.text().isEmpty() ? line.placeholderText() : line.text();
    constexpr int kMargin = 4;  // of Qt's line control, left and right of the text
    const QMargins margins = line.textMargins();
    const int room = line.contentsRect().width() - margins.left() - margins.right() - kMargin;
    return Fit{text, {room, line.height()}, {widthOf(line, QString(text).replace('&', "&&")), 0}};
}

std::optional<Fit> fitOf(const QComboBox& box) {
    if (box.isEditable() || box.currentText().isEmpty()) return std::nullopt;
    QStyleOptionComboBox option;
    option.initFrom(&box);
    const QRect field = box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box);
    const int icon = box.itemIcon(box.currentIndex()).isNull() ? 0 : box.iconSize().width() + 4;
    return Fit{box.currentText(), {field.width() - icon, field.height()}, {widthOf(box, box.currentText()), 0}};
}

std::optional<Fit> fitOf(const QProgressBar& bar) {
    if (!bar.isTextVisible()) return std::nullopt;
    return Fit{bar.text(), bar.contentsRect().size(), {bar.fontMetrics().horizontalAdvance(bar.text()), 0}};
}

std::optional<Fit> fitOf(const QWidget& widget) {
    if (const auto* label = qobject_cast<const QLabel*>(&widget)) return fitOf(*label);
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return fitOf(*button);
    if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) return fitOf(*line);
    if (const auto* box = qobject_cast<const QComboBox*>(&widget)) return fitOf(*box);
    if (const auto* bar = qobject_cast<const QProgressBar*>(&widget)) return fitOf(*bar);
    return std::nullopt;
}

/// The visible children, without those of docks below the root: a dock behind another is visible to Qt.
std::vector<const QWidget*> visibleChildren(const QWidget& root) {
    std::vector<const QWidget*> visible;
    for (const QWidget* widget : root.findChildren<QWidget*>()) {
        bool isInDock = false;
        for (const QWidget* at = widget; at != &root && !isInDock; at = at->parentWidget()) {
            isInDock = qobject_cast<const QDockWidget*>(at) != nullptr;
        }
        if (widget->isVisible() && !isInDock) visible.push_back(widget);
    }
    return visible;
}

/// True if a part of the widget lies left or right of the window or scroll area around it: nobody scrolls sideways.
bool isCutOff(const QWidget& widget) {
    for (const QWidget* parent = widget.parentWidget(); parent != nullptr; parent = parent->parentWidget()) {
        const int left = widget.mapTo(parent, QPoint()).x();
        if (left < 0 || left + widget.width() > parent->width()) return true;
        if (parent->isWindow() || qobject_cast<const QAbstractScrollArea*>(parent->parentWidget())) break;
    }
    return false;
}

void addHeader(const QHeaderView& header, QStringList& clipped) {
    for (int k = 0; k < header.count(); ++k) {
        const QString text = header.model()->headerData(k, header.orientation()).toString();
        if (header.isSectionHidden(k) || text.isEmpty() || header.orientation() == Qt::Vertical) continue;
        const int need = header.fontMetrics().horizontalAdvance(text);
        if (header.sectionSize(k) < need) {
            clipped << QString("column '%1': %2 of %3").arg(text).arg(header.sectionSize(k)).arg(need);
        }
    }
}

void addTabs(const QTabBar& bar, QStringList& clipped) {
    for (int k = 0; k < bar.count(); ++k) {
        const int need = widthOf(bar, bar.tabText(k));
        if (bar.tabRect(k).width() < need) {
            clipped << QString("tab '%1': %2 of %3").arg(bar.tabText(k)).arg(bar.tabRect(k).width()).arg(need);
        }
    }
}

double luminance(const QColor& colour) {
    const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

double contrast(const QColor& first, const QColor& second) {
    const double one = luminance(first), other = luminance(second);
    return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

}  // namespace

QStringList clippedTexts(const QWidget& root) {
    QStringList clipped;
    for (const QWidget* widget : visibleChildren(root)) {
        if (const auto* header = qobject_cast<const QHeaderView*>(widget)) addHeader(*header, clipped);
        if (const auto* tabs = qobject_cast<const QTabBar*>(widget)) addTabs(*tabs, clipped);
        if (const auto* bar = qobject_cast<const QToolBar*>(widget); bar && bar->width() < bar->sizeHint().width()) {
            const int room = bar->width(), need = bar->sizeHint().width();
            clipped << QString("tool bar '%1': %2 of %3").arg(bar->windowTitle()).arg(room).arg(need);
        }
        const std::optional<Fit> fit = fitOf(*widget);
        if (!fit) continue;
        const QString name = QString("%1 '%2'").arg(widget->metaObject()->className(), fit->text.left(60));
        if (fit->room.width() < fit->need.width())
            clipped << QString("%1: %2 of %3").arg(name).arg(fit->room.width()).arg(fit->need.width());
        if (fit->room.height() < fit->need.height())
            clipped << QString("%1: height %2 of %3").arg(name).arg(fit->room.height()).arg(fit->need.height());
        if (isCutOff(*widget)) clipped << name + " lies outside";
    }
    return clipped;
}

QStringList faintTexts(const QWidget& root) {
    QStringList faint;
    for (const QWidget* widget : visibleChildren(root)) {
        if (!widget->isEnabled()) continue;
        const std::optional<Fit> fit = fitOf(*widget);
        if (!fit || fit->text.isEmpty()) continue;
        const QPalette& palette = widget->palette();
        const double value = contrast(palette.color(widget->foregroundRole()), palette.color(widget->backgroundRole()));
        if (value < kMinContrast) {
            faint << QString("%1 '%2': %3").arg(widget->metaObject()->className(), fit->text.left(60)).arg(value);
        }
    }
    return faint;
}

}  // namespace rubble::test
