#include "editor/panels/inspector/MortarSection.h"

#include "editor/commands/InstanceEdits.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/commands/Renaming.h"
#include "editor/document/ShownText.h"
#include "editor/widgets/Buttons.h"
#include "editor/widgets/ProjectRange.h"
#include "editor/widgets/SliderField.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"

#include <QHBoxLayout>
#include <QListWidget>
#include <QScopedValueRollback>

#include <algorithm>
#include <set>

namespace rubble {

namespace {

constexpr int kMinVisibleRows = 3;  // a shorter list looks like a field
constexpr int kMaxVisibleMortars = 4;
constexpr int kMaxVisibleInstances = 6;

/// Makes a list as high as its rows, within limits.
void fitRows(QListWidget& list, int most) {
    const int rows = std::clamp(list.count(), kMinVisibleRows, most);
    const int row = std::max(list.sizeHintForRow(0), list.fontMetrics().height());
    list.setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);  // otherwise the section grows
    list.setFixedHeight(rows * row + 2 * list.frameWidth());
}

Id idOf(const QListWidgetItem& item) { return item.data(Qt::UserRole).toUInt(); }

/// Shows names, with ids, in a list. Items of the same ids are kept: one may be clicked right now.
void showNames(QListWidget& list, const std::vector<std::pair<Id, std::string>>& names) {
    std::vector<Id> shown, wanted;
    for (int row = 0; row < list.count(); ++row) shown.push_back(idOf(*list.item(row)));
    for (const auto& [id, name] : names) wanted.push_back(id);
    if (shown != wanted) {
        list.clear();
        for (const Id id : wanted) (new QListWidgetItem(&list))->setData(Qt::UserRole, id);
    }
    for (std::size_t row = 0; row < names.size(); ++row)
        list.item(static_cast<int>(row))->setText(nameText(names[row].second));
}

}  // namespace

MortarSection::MortarSection(Document& document, Selection& selection, const MortarWatch& joints, QWidget* parent)
    : Section("mortar", tr("Mortar"), parent),
      m_document(document),
      m_selection(selection),
      m_joints(joints),
      m_form(
          document, [this] { return selected(); }, pushOf<Mortar>(document)),
      m_note(new QLabel),
      m_list(new QListWidget) {
    m_form.setRefused([this](const QString& sentence) { emit refused(sentence); });
    m_form.setFault([&document](const Mortar& mortar) {
        return nameFault(document.project(), Part::Mortar, mortar.id, QString::fromStdString(mortar.name));
    });
    buildList();
    buildNumbers();
    buildInstances();
    connect(&joints, &MortarWatch::changed, this, &MortarSection::showJoints);
    connect(&selection, &Selection::mortarChanged, this, &MortarSection::refresh);
}

std::vector<Mortar> MortarSection::selected() const {
    const Mortar* mortar = findMortar(m_document.project(), m_selection.mortar());
    return mortar ? std::vector{*mortar} : std::vector<Mortar>{};
}

/// The instances that mortar can join.
std::vector<Id> MortarSection::bonded() const {
    std::vector<Id> all;
    for (const Instance& instance : m_document.project().instances) all.push_back(instance.id);
    return bondedInstances(m_document.project(), all);
}

void MortarSection::buildList() {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    auto* add = panelButton("add", tr("Add Mortar"), tr("Add a mortar that joins all bonded instances"), row);
    m_remove = panelButton("remove", tr("Delete Mortar"), tr("Delete the selected mortar"), row);
    layout->addWidget(new QLabel(tr("Mortars")), 1);
    for (QToolButton* button : {add, m_remove}) layout->addWidget(button);
    addWide(row);
    m_note->setWordWrap(true);
    m_note->setObjectName("mortarNote");
    addWide(m_note);
    m_list->setAccessibleName(tr("Mortars"));
    m_list->setToolTip(tr("Select a mortar to edit it and to see its joints in the 3D view"));
    addWide(m_list);
    connect(add, &QToolButton::clicked, this, &MortarSection::add);
    connect(m_remove, &QToolButton::clicked, this, &MortarSection::remove);
    connect(m_list, &QListWidget::itemSelectionChanged, this, [this] {
        if (m_isShowing) return;
        const QList<QListWidgetItem*> items = m_list->selectedItems();
        m_selection.setMortar(items.isEmpty() ? 0 : idOf(*items.front()));
    });
}

void MortarSection::buildNumbers() {
    auto* name = addRow(tr("Name"), new QLineEdit, tr("Name of the mortar"));
    m_form.bind(
        name, tr("Rename"), [](const Mortar& mortar) { return QString::fromStdString(mortar.name); },
        [](Mortar& mortar, const QString& entered) { mortar.name = entered.trimmed().toStdString(); });
    auto* impulse =
        addRow(tr("Impulse per area"),
               new SliderField(fieldRange(ProjectNumber::BondImpulse), 10.0, 100'000.0, SliderScale::Logarithmic),
               tr("Set the impulse that breaks a joint, by its area"));
    impulse->setFormat(Units::impulsesPerArea());
    m_form.bind(impulse, tr("Set Strength of Mortar"), &Mortar::impulsePerArea);
    m_tolerance = addRow(tr("Widest joint"), new NumberField, tr("Join faces that are at most this far apart"));
    m_tolerance->setRange(fieldRange(ProjectNumber::MortarTolerance));
    m_form.bind(m_tolerance, tr("Set Widest Joint"), &Mortar::tolerance);
    m_leastArea =
        addRow(tr("Least area"), new NumberField, tr("Leave out fragments that share a smaller area with each other"));
    m_leastArea->setRange(fieldRange(ProjectNumber::MortarLeastArea));
    m_form.bind(m_leastArea, tr("Set Least Area of Joints"), &Mortar::leastArea);
    m_rows = {name, impulse, m_tolerance, m_leastArea};
}

void MortarSection::buildInstances() {
    m_joinsAll = new QCheckBox(tr("Join All Bonded Instances"));
    m_joinsAll->setToolTip(tr("Also join instances that are added later"));
    addWide(m_joinsAll);
    m_instances = new QListWidget;
    m_instances->setAccessibleName(tr("Joined Instances"));
    m_instances->setToolTip(tr("Check the instances that the mortar joins"));
    m_instances->setSelectionMode(QAbstractItemView::NoSelection);
    addWide(m_instances);
    m_result = new QLabel;
    m_result->setObjectName("joints");
    m_result->setWordWrap(true);
    addWide(m_result);
    connect(m_joinsAll, &QCheckBox::clicked, this, &MortarSection::toggleAll);
    connect(m_instances, &QListWidget::itemChanged, this, [this](const QListWidgetItem* item) {
        if (!m_isShowing) toggleInstance(idOf(*item), item->checkState() == Qt::Checked);
    });
}

void MortarSection::add() {
    Addition addition = addMortar(m_document.project(), {});
    if (m_document.push(std::move(addition.edit))) m_selection.setMortar(addition.id);
}

/// Selects the next mortar, or the previous one if the last was deleted.
void MortarSection::remove() {
    const std::vector<Mortar>& mortars = m_document.project().mortars;
    const auto removed = std::ranges::find(mortars, m_selection.mortar(), &Mortar::id);
    if (removed == mortars.end()) return;
    Id neighbour = 0;
    if (removed + 1 != mortars.end()) {
        neighbour = (removed + 1)->id;
    } else if (removed != mortars.begin()) {
        neighbour = (removed - 1)->id;
    }
    if (m_document.push(removeMortar(removed->id))) m_selection.setMortar(neighbour);
}

void MortarSection::setInstances(const QString& text, std::vector<Id> instances) {
    for (Mortar mortar : selected()) {
        mortar.instances = std::move(instances);
        m_document.push(modify(text, std::move(mortar)));
    }
    refresh();  // the click changed a check mark, whether or not the project changed
}

void MortarSection::toggleAll(bool isOn) {
    setInstances(isOn ? tr("Join All Instances") : tr("Join Some Instances"), isOn ? std::vector<Id>() : bonded());
}

/// At least one stays: a mortar without any joins all.
void MortarSection::toggleInstance(Id instance, bool isOn) {
    const std::vector<Mortar> mortars = selected();
    if (mortars.empty()) return;
    std::set<Id> joined(mortars[0].instances.begin(), mortars[0].instances.end());
    isOn ? void(joined.insert(instance)) : void(joined.erase(instance));
    if (joined.empty()) {
        emit refused(tr("The last instance cannot be left out. Delete the mortar instead."));
        return refresh();
    }
    setInstances(isOn ? tr("Join Instance") : tr("Leave Out Instance"), {joined.begin(), joined.end()});
}

void MortarSection::showList() {
    std::vector<std::pair<Id, std::string>> names;
    for (const Mortar& mortar : m_document.project().mortars) names.emplace_back(mortar.id, mortar.name);
    showNames(*m_list, names);
    for (int row = 0; row < m_list->count(); ++row)
        m_list->item(row)->setSelected(idOf(*m_list->item(row)) == m_selection.mortar());
    fitRows(*m_list, kMaxVisibleMortars);
    m_list->setVisible(m_list->count() > 0);
    m_remove->setEnabled(m_selection.mortar() != 0);
}

/// The bonded instances, and those that are no longer bonded but named.
void MortarSection::showInstances(const Mortar& mortar) {
    const bool joinsAll = mortar.instances.empty();
    m_joinsAll->setChecked(joinsAll);
    m_instances->setVisible(!joinsAll);
    const std::vector<Id> candidates = bonded();
    m_joinsAll->setEnabled(!joinsAll || !candidates.empty());
    if (joinsAll) return;
    const auto isJoined = [&](Id instance) { return std::ranges::binary_search(mortar.instances, instance); };
    std::vector<std::pair<Id, std::string>> names;
    for (const Instance& instance : m_document.project().instances) {
        const bool isCandidate = std::ranges::find(candidates, instance.id) != candidates.end();
        if (isCandidate || isJoined(instance.id)) names.emplace_back(instance.id, instance.name);
    }
    showNames(*m_instances, names);
    for (int row = 0; row < m_instances->count(); ++row) {
        QListWidgetItem& item = *m_instances->item(row);
        item.setCheckState(isJoined(idOf(item)) ? Qt::Checked : Qt::Unchecked);
    }
    fitRows(*m_instances, kMaxVisibleInstances);
}

QString MortarSection::jointText(const JoinedMortar& joined) const {
    if (joined.joints.empty())
        return tr("No faces of these instances are as near to each other as the widest joint, or they are too small.");
    double area = 0.0;
    std::set<std::pair<Id, Id>> pairs;
    for (const MortarJoint& joint : joined.joints) {
        area += joint.area;
        pairs.insert({joint.first, joint.second});
    }
    const QString joints = tr("%Ln joint(s) of fragments", nullptr, static_cast<int>(joined.joints.size()));
    const QString found =
        tr("%1 between %Ln pair(s) of instances, %2 together.", nullptr, static_cast<int>(pairs.size()))
            .arg(joints, roundedQuantity(area, m_units.areas(), locale()));
    return joined.isHeld ? found : tr("%1 They hold nothing, since none of the instances is anchored.").arg(found);
}

void MortarSection::showJoints() {
    const JoinedMortar* joined = m_joints.find(m_selection.mortar());
    if (m_joints.error()) {
        m_result->setText(QString::fromStdString(m_joints.error()->message));
    } else {
        m_result->setText(joined ? jointText(*joined) : tr("Finding the joints…"));
    }
    m_result->setVisible(m_selection.mortar() != 0);
}

void MortarSection::setUnits(const Units& units) {
    m_units = units;
    m_tolerance->setFormat(units.lengths());
    m_leastArea->setFormat(units.areas());
}

void MortarSection::refresh() {
    const QScopedValueRollback showing(m_isShowing, true);
    const std::vector<Mortar> mortars = selected();
    setVisible(!m_document.project().mortars.empty() || !bonded().empty());
    showList();
    for (QWidget* row : m_rows) setRowVisible(row, !mortars.empty());
    m_note->setVisible(mortars.empty());
    m_note->setText(m_document.project().mortars.empty()
                        ? tr("Mortar joins bonded instances where their faces lie against each other.")
                        : tr("Select a mortar to edit it and to see its joints."));
    m_joinsAll->setVisible(!mortars.empty());
    m_instances->setVisible(!mortars.empty());
    if (!mortars.empty()) showInstances(mortars[0]);
    m_form.refresh();
    showJoints();
}

}  // namespace rubble

#include "moc_MortarSection.cpp"
