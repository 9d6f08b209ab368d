#include "editor/dialogs/sheet/VariationTree.h"

#include "core/fracture/pattern/PatternKind.h"
#include "editor/widgets/Icon.h"
#include "editor/widgets/appearance/LayerText.h"

#include <QHeaderView>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace rubble {

namespace {

constexpr int kKeyRole = Qt::UserRole;        // name of the kind or parameter
constexpr int kLayerRole = Qt::UserRole + 1;  // id; 0: a kind
constexpr double kDefaultFrom = 0.5;          // default range of a parameter, relative to its value
constexpr double kDefaultTo = 1.5;

enum VariationColumn { Name, From, To };

double numberOf(const ParameterValue& value) {
    const auto* count = std::get_if<SeedCount>(&value);
    return count ? count->amount : std::get<double>(value);
}

/// Returns NaN, which is no valid range, if the text is not a number.
double parsed(const QString& text) {
    bool isNumber = false;
    const double number = QLocale().toDouble(text, &isNumber);
    return isNumber ? number : std::numeric_limits<double>::quiet_NaN();
}

QTreeWidgetItem* addCheckable(QTreeWidgetItem* parent, const QString& text, std::string_view key, quint32 layer) {
    auto* item = new QTreeWidgetItem(parent, {text});
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable | Qt::ItemIsEditable);
    item->setCheckState(Name, Qt::Unchecked);
    item->setData(Name, kKeyRole, QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size())));
    item->setData(Name, kLayerRole, layer);
    return item;
}

/// Returns the default range of a parameter, within its limits; integral for an integral parameter.
std::pair<double, double> defaultRange(const LayerParameter& parameter, const LayerParameters& of) {
    const ParameterValue value = parameter.read(of);
    const double number = numberOf(value);
    const auto* count = std::get_if<SeedCount>(&value);
    const bool isWhole = parameter.type == ParameterType::Whole || (count && count->by == CountBy::Number);
    double min = std::max(parameter.range.min, std::min(kDefaultFrom * number, kDefaultTo * number));
    double max = std::min(parameter.range.max, std::max(kDefaultFrom * number, kDefaultTo * number));
    if (isWhole) min = std::floor(min), max = std::ceil(max);
    return {min, max};
}

/// Identifies a row: the layer's id and the parameter's name; 0 and the name of a kind.
using RowKey = std::pair<quint32, QString>;
RowKey keyOf(const QTreeWidgetItem& item) {
    return {item.data(Name, kLayerRole).toUInt(), item.data(Name, kKeyRole).toString()};
}

/// Calls visit(item) for every checked row.
template <class Visit>
void forEachChecked(const QTreeWidget& tree, Visit visit) {
    for (QTreeWidgetItemIterator item(const_cast<QTreeWidget*>(&tree), QTreeWidgetItemIterator::Checked); *item;
         ++item) {
        visit(**item);
    }
}

}  // namespace

VariationTree::VariationTree(QWidget* parent) : QTreeWidget(parent) {
    setColumnCount(3);
    setHeaderLabels({tr("Parameter"), tr("From"), tr("To")});
    setAccessibleName(tr("Varied parameters"));
    setObjectName("variation-tree");
    setEditTriggers(DoubleClicked | EditKeyPressed | AnyKeyPressed);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(Name, QHeaderView::Stretch);
    header()->setSectionResizeMode(From, QHeaderView::ResizeToContents);
    header()->setSectionResizeMode(To, QHeaderView::ResizeToContents);
}

void VariationTree::setAsset(const Asset& asset) {
    std::map<RowKey, QStringList> checked;  // with their ranges
    forEachChecked(*this, [&](const QTreeWidgetItem& item) {
        checked[keyOf(item)] = {item.text(From), item.text(To)};
    });
    clear();
    for (const PatternLayer& layer : asset.pattern.layers) addLayer(layer);
    addKinds();
    for (QTreeWidgetItemIterator item(this); *item; ++item) {
        const auto before = checked.find(keyOf(**item));
        if (before == checked.end()) continue;
        (*item)->setCheckState(Name, Qt::Checked);
        (*item)->setText(From, before->second[0]);
        (*item)->setText(To, before->second[1]);
    }
}

void VariationTree::addLayer(const PatternLayer& layer) {
    auto* parent = new QTreeWidgetItem(this, {layerKindName(layer.parameters)});
    parent->setIcon(Name, iconNamed(kindOf(layer.parameters).icon));
    parent->setFlags(Qt::ItemIsEnabled);
    for (const LayerParameter& parameter : kindOf(layer.parameters).parameters) {
        const bool isNotNumeric = parameter.type == ParameterType::Option || parameter.type == ParameterType::Point;
        if (isNotNumeric || !parameter.isUsed(layer.parameters)) continue;
        const auto [min, max] = defaultRange(parameter, layer.parameters);
        QTreeWidgetItem* item = addCheckable(parent, patternText(parameter.caption), parameter.name, layer.id);
        item->setToolTip(Name, patternText(parameter.hint));
        item->setText(From, QLocale().toString(min, 'g', 6));
        item->setText(To, QLocale().toString(max, 'g', 6));
    }
    parent->setHidden(parent->childCount() == 0);
    parent->setExpanded(true);
}

void VariationTree::addKinds() {
    auto* parent = new QTreeWidgetItem(this, {tr("Layer kinds")});
    parent->setIcon(Name, iconNamed("layer-add"));
    parent->setFlags(Qt::ItemIsEnabled);
    for (const PatternKind* kind : variedKinds()) {
        QTreeWidgetItem* item = addCheckable(parent, patternText(kind->caption), kind->name, 0);
        item->setFlags(item->flags() & ~Qt::ItemIsEditable);
        item->setToolTip(Name, patternText(kind->hint));
    }
    parent->setExpanded(true);
}

std::vector<std::string> VariationTree::kinds() const {
    std::vector<std::string> names;
    forEachChecked(*this, [&](const QTreeWidgetItem& item) {
        const auto [layer, name] = keyOf(item);
        if (layer == 0) names.push_back(name.toStdString());
    });
    return names;
}

std::vector<VariedParameter> VariationTree::varied() const {
    std::vector<VariedParameter> varied;
    forEachChecked(*this, [&](const QTreeWidgetItem& item) {
        const auto [layer, name] = keyOf(item);
        if (layer == 0) return;
        varied.push_back({layer, name.toStdString(), parsed(item.text(From)), parsed(item.text(To))});
    });
    return varied;
}

}  // namespace rubble

#include "moc_VariationTree.cpp"
