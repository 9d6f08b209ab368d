#include "editor/panels/docks/InstanceIconDelegate.h"

#include "editor/panels/models/ProjectModel.h"
#include "editor/widgets/Icon.h"

#include <QAbstractItemView>
#include <QHelpEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QStyle>
#include <QToolTip>

#include <algorithm>
#include <array>

namespace rubble {

namespace {

constexpr int kSize = 16;  // pixels
constexpr int kGap = 4;    // pixels, beside each
constexpr double kFadedOpacity = 0.35;

QString iconOf(int role, bool isOn) {
    if (role == ProjectModel::kHiddenRole) return isOn ? QStringLiteral("hide") : QStringLiteral("show");
    return isOn ? QStringLiteral("instance-lock") : QStringLiteral("instance-unlock");
}

QString tipOf(int role, bool isOn) {
    if (role == ProjectModel::kHiddenRole) {
        return isOn ? InstanceIconDelegate::tr("Show in the 3D view") : InstanceIconDelegate::tr("Hide in the 3D view");
    }
    return isOn ? InstanceIconDelegate::tr("Allow selecting and moving in the 3D view")
                : InstanceIconDelegate::tr("Prevent selecting and moving in the 3D view");
}

}  // namespace

InstanceIconDelegate::InstanceIconDelegate(QAbstractItemView& view) : QStyledItemDelegate(&view), m_view(view) {
    view.viewport()->installEventFilter(this);
    view.viewport()->setMouseTracking(true);
}

QRect InstanceIconDelegate::iconRect(const QModelIndex& index, int role) const {
    const QRect row = m_view.visualRect(index);
    const int fromEnd = role == ProjectModel::kLockedRole ? 1 : 2;
    const int left = m_view.viewport()->width() - fromEnd * (kSize + kGap);
    return {left, row.center().y() - kSize / 2, kSize, kSize};
}

void InstanceIconDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                                 const QModelIndex& index) const {
    QStyleOptionViewItem textOption = option;
    const bool hasIcons = index.data(ProjectModel::kHiddenRole).isValid();
    if (hasIcons) {
        // The selection is drawn behind the icons, too; the text ends before them.
        QStyleOptionViewItem row = option;
        row.rect.setRight(m_view.viewport()->width());
        m_view.style()->drawPrimitive(QStyle::PE_PanelItemViewItem, &row, painter, &m_view);
        textOption.rect.setRight(iconRect(index, ProjectModel::kHiddenRole).left() - kGap);
    }
    QStyledItemDelegate::paint(painter, textOption, index);
    if (!hasIcons) return;
    for (const int role : {ProjectModel::kHiddenRole, ProjectModel::kLockedRole}) {
        const bool isOn = index.data(role).toBool();
        if (!isOn && !option.state.testFlag(QStyle::State_MouseOver)) continue;
        painter->setOpacity(isOn ? 1.0 : kFadedOpacity);
        iconNamed(iconOf(role, isOn)).paint(painter, iconRect(index, role));
        painter->setOpacity(1.0);
    }
}

std::optional<int> InstanceIconDelegate::roleAt(QPoint point) const {
    const QModelIndex index = m_view.indexAt({0, point.y()});
    if (!index.data(ProjectModel::kHiddenRole).isValid()) return std::nullopt;
    for (const int role : {ProjectModel::kHiddenRole, ProjectModel::kLockedRole}) {
        if (iconRect(index, role).adjusted(-kGap / 2, -kGap / 2, kGap / 2, kGap / 2).contains(point)) return role;
    }
    return std::nullopt;
}

bool InstanceIconDelegate::helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                                     const QModelIndex& index) {
    const std::optional<int> role = roleAt(event->pos());
    if (!role) return QStyledItemDelegate::helpEvent(event, view, option, index);
    QToolTip::showText(event->globalPos(), tipOf(*role, index.data(*role).toBool()), view);
    return true;
}

/// Whether an event would end the editing of a name that the model refuses. The row that is edited is the current one.
bool InstanceIconDelegate::isRefused(QObject* editor, const QEvent& event) const {
    auto* line = qobject_cast<QLineEdit*>(editor);
    if (!line || !m_view.model()) return false;
    const bool isFocusOut = event.type() == QEvent::FocusOut;
    if (!isFocusOut && event.type() != QEvent::KeyPress) return false;
    constexpr std::array kEndKeys{Qt::Key_Return, Qt::Key_Enter, Qt::Key_Tab, Qt::Key_Backtab};
    if (!isFocusOut && std::ranges::find(kEndKeys, static_cast<const QKeyEvent&>(event).key()) == kEndKeys.end())
        return false;
    const QModelIndex index = m_view.currentIndex();
    return index.isValid() && !static_cast<ProjectModel*>(m_view.model())->acceptsName(index, line->text());
}

bool InstanceIconDelegate::eventFilter(QObject* watched, QEvent* event) {
    if (isRefused(watched, *event)) return event->type() == QEvent::KeyPress;
    const bool isPress = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick;
    // A view that is being destroyed has no viewport any more.
    if (!isPress || watched != m_view.viewport()) return QStyledItemDelegate::eventFilter(watched, event);
    const auto& mouse = static_cast<QMouseEvent&>(*event);
    const std::optional<int> role = roleAt(mouse.position().toPoint());
    if (!role || mouse.button() != Qt::LeftButton) return false;
    const QModelIndex index = m_view.indexAt({0, mouse.position().toPoint().y()});
    m_view.model()->setData(index, !index.data(*role).toBool(), *role);
    return true;
}

}  // namespace rubble

#include "moc_InstanceIconDelegate.cpp"
