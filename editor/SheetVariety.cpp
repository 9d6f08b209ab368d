#include "editor/SheetVariety.h"

#include "core/fracture/PatternKind.h"
#include "editor/commands/LayerKind.h"
#include "editor/icons/Icon.h"
#include "editor/panels/LayerText.h"

#include <QHeaderView>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace rubble {

namespace {

constexpr int kKey = Qt::UserRole;        // of a ticked row: the kind's name, or the parameter's
constexpr int kLayer = Qt::UserRole + 1;  // id; 0: a kind
constexpr double kUsualFrom = 0.5;        // of a parameter's number: where its range begins and ends at first
constexpr double kUsualTo = 1.5;

enum Column { Name, From, To };

double numberOf(const ParameterValue& value) {
    const auto* count = std::get_if<SeedCount>(&value);
    return count ? count->amount : std::get<double>(value);
}

/// NaN where it is no number, which is refused as a range.
double typed(const QString& text) {
    bool isNumber = false;
    const double number = QLocale().toDouble(text, &isNumber);
    return isNumber ? number : std::numeric_limits<double>::quiet_NaN();
}

QTreeWidgetItem* addTicked(QTreeWidgetItem* parent, const QString& text, std::string_view key, quint32 layer) {
    auto* item = new QTreeWidgetItem(parent, {text});
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable | Qt::ItemIsEditable);
    item->setCheckState(Name, Qt::Unchecked);
    item->setData(Name, kKey, QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size())));
    item->setData(Name, kLayer, layer);
    return item;
}

/// From half of a parameter's number to one and a half, within what it takes; whole where it is.
std::pair<double, double> usualRange(const LayerParameter& parameter, const LayerParameters& of) {
    const ParameterValue value = parameter.read(of);
    const double number = numberOf(value);
    const auto* count = std::get_if<SeedCount>(&value);
    const bool isWhole = parameter.type == ParameterType::Whole || (count && count->by == CountBy::Number);
    double least = std::max(parameter.range.min, std::min(kUsualFrom * number, kUsualTo * number));
    double most = std::min(parameter.range.max, std::max(kUsualFrom * number, kUsualTo * number));
    if (isWhole) least = std::floor(least), most = std::ceil(most);
    return {least, most};
}

/// By what a row is known again: the layer's id and the parameter's name, or the kind's.
using RowKey = std::pair<quint32, QString>;
RowKey keyOf(const QTreeWidgetItem& item) {
    return {item.data(Name, kLayer).toUInt(), item.data(Name, kKey).toString()};
}

/// Calls visit(item) for every row that is ticked.
template <class Visit>
void forEachTicked(const QTreeWidget& tree, Visit visit) {
    for (QTreeWidgetItemIterator item(const_cast<QTreeWidget*>(&tree), QTreeWidgetItemIterator::Checked); *item;
         ++item) {
        visit(**item);
    }
}

}  // namespace

SheetVariety::SheetVariety(QWidget* parent) : QTreeWidget(parent) {
    setColumnCount(3);
    setHeaderLabels({tr("Varies"), tr("From"), tr("To")});
    setAccessibleName(tr("What varies"));
    setObjectName("sheet-variety");
    setEditTriggers(DoubleClicked | EditKeyPressed | AnyKeyPressed);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(Name, QHeaderView::Stretch);
    header()->setSectionResizeMode(From, QHeaderView::ResizeToContents);
    header()->setSectionResizeMode(To, QHeaderView::ResizeToContents);
}

void SheetVariety::setAsset(const Asset& asset) {
    std::map<RowKey, QStringList> ticked;  // with the ranges that were typed
    forEachTicked(*this, [&](const QTreeWidgetItem& item) { ticked[keyOf(item)] = {item.text(From), item.text(To)}; });
    clear();
    for (const PatternLayer& layer : asset.pattern.layers) addLayer(layer);
    addKinds();
    for (QTreeWidgetItemIterator item(this); *item; ++item) {
        const auto before = ticked.find(keyOf(**item));
        if (before == ticked.end()) continue;
        (*item)->setCheckState(Name, Qt::Checked);
        (*item)->setText(From, before->second[0]);
        (*item)->setText(To, before->second[1]);
    }
}

void SheetVariety::addLayer(const PatternLayer& layer) {
    auto* parent = new QTreeWidgetItem(this, {kindText(layer.parameters)});
    parent->setIcon(Name, iconNamed(kindIconName(layer.parameters)));
    parent->setFlags(Qt::ItemIsEnabled);
    for (const LayerParameter& parameter : kindOf(layer.parameters).parameters) {
        const bool isChosenOrPlace = parameter.type == ParameterType::Choice || parameter.type == ParameterType::Point;
        if (isChosenOrPlace || (parameter.isUsed && !parameter.isUsed(layer.parameters))) continue;
        const auto [least, most] = usualRange(parameter, layer.parameters);
        QTreeWidgetItem* item = addTicked(parent, patternText(parameter.caption), parameter.name, layer.id);
        item->setToolTip(Name, patternText(parameter.hint));
        item->setText(From, QLocale().toString(least, 'g', 6));
        item->setText(To, QLocale().toString(most, 'g', 6));
    }
    parent->setHidden(parent->childCount() == 0);
    parent->setExpanded(true);
}

void SheetVariety::addKinds() {
    auto* parent = new QTreeWidgetItem(this, {tr("Kinds of patterns, by turns")});
    parent->setIcon(Name, iconNamed("layer-add"));
    parent->setFlags(Qt::ItemIsEnabled);
    for (const PatternKind* kind : variedKinds()) {
        QTreeWidgetItem* item = addTicked(parent, patternText(kind->caption), kind->name, 0);
        item->setFlags(item->flags() & ~Qt::ItemIsEditable);
        item->setToolTip(Name, patternText(kind->hint));
    }
    parent->setExpanded(true);
}

std::vector<std::string> SheetVariety::kinds() const {
    std::vector<std::string> names;
    forEachTicked(*this, [&](const QTreeWidgetItem& item) {
        const auto [layer, name] = keyOf(item);
        if (layer == 0) names.push_back(name.toStdString());
    });
    return names;
}

std::vector<VariedParameter> SheetVariety::varied() const {
    std::vector<VariedParameter> varied;
    forEachTicked(*this, [&](const QTreeWidgetItem& item) {
        const auto [layer, name] = keyOf(item);
        if (layer == 0) return;
        varied.push_back({layer, name.toStdString(), typed(item.text(From)), typed(item.text(To))});
    });
    return varied;
}

}  // namespace rubble
