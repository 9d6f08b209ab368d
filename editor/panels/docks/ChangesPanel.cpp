#include "editor/panels/docks/ChangesPanel.h"

#include "editor/document/ShownText.h"
#include "editor/widgets/Buttons.h"

#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

namespace {

QString iconOf(FragmentChange change) {
    switch (change) {
        case FragmentChange::Gone: return QStringLiteral("change-gone");
        case FragmentChange::Added: return QStringLiteral("change-added");
        case FragmentChange::Moved: return QStringLiteral("change-moved");
        case FragmentChange::Reshaped: break;
    }
    return QStringLiteral("change-reshaped");
}

}  // namespace

ChangesPanel::ChangesPanel(const StateComparison& comparison, const Selection& selection, const Document& document,
                           QWidget* parent)
    : QWidget(parent),
      m_comparison(comparison),
      m_selection(selection),
      m_document(document),
      m_title(new QLabel),
      m_list(new QListWidget) {
    m_title->setWordWrap(true);
    m_title->setMargin(6);
    m_title->setTextFormat(Qt::PlainText);
    m_title->setObjectName("changes-title");
    m_list->setObjectName("changes");
    m_list->setAccessibleName(tr("Changes"));
    m_list->setFrameShape(QFrame::NoFrame);
    m_list->setWordWrap(true);
    m_list->setAlternatingRowColors(true);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(0);
    rows->addWidget(m_title);
    rows->addWidget(m_list, 1);
    setFocusProxy(m_list);
    connect(&comparison, &StateComparison::changed, this, &ChangesPanel::refresh);
    connect(m_list, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
        const int fragment = item->data(Qt::UserRole).toInt();
        const auto& compared = m_comparison.value();
        if (compared && fragment >= 0)
            emit jumpRequested(compared->fragments.fragments[static_cast<std::size_t>(fragment)]);
    });
    refresh();
}

void ChangesPanel::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) return emit dismissed();
    QWidget::keyPressEvent(event);
}

void ChangesPanel::add(const QString& icon, const QString& text, int fragment) {
    auto* item = new QListWidgetItem(icon.isEmpty() ? QIcon() : iconNamed(icon), text, m_list);
    item->setData(Qt::UserRole, fragment);
    item->setToolTip(toolTipText(text));
}

void ChangesPanel::refresh() {
    m_list->clear();
    const Asset* asset = findAsset(m_document.project(), m_selection.asset());
    if (!asset) return m_title->setText(tr("No asset selected"));
    const QString name = nameText(asset->name);
    m_title->setText(tr("%1, compared with %2").arg(name, m_comparison.name()));
    if (m_comparison.error()) return add({}, QString::fromStdString(m_comparison.error()->message));
    if (m_comparison.value()) return fill(*m_comparison.value());
    add({}, tr("Comparing…"));
}

void ChangesPanel::fill(const ComparedAsset& compared) {
    if (!compared.existedBefore) return add("change-added", tr("The asset is new."));
    if (compared.isEmpty()) return add({}, tr("No changes"));
    for (const RecipeChange& change : compared.recipe) {
        add("change-recipe", QString::fromStdString(sentenceOf(change)));
    }
    const std::vector<LevelDifference>& levels = compared.fragments.levels;
    for (std::size_t k = 0; k < levels.size(); ++k) {
        const QString sentence = QString::fromStdString(sentenceOf(levels[k]));
        add("dock-fragments", levels.size() > 1 ? tr("Level %1: %2").arg(k).arg(sentence) : sentence);
    }
    const std::vector<FragmentDifference>& fragments = compared.fragments.fragments;
    for (std::size_t k = 0; k < std::min(fragments.size(), kMaxListed); ++k) {
        add(iconOf(fragments[k].change), QString::fromStdString(sentenceOf(fragments[k])), static_cast<int>(k));
    }
    if (fragments.size() > kMaxListed) add({}, tr("… and %L1 more").arg(fragments.size() - kMaxListed));
}

}  // namespace rubble

#include "moc_ChangesPanel.cpp"
