// Tests editor/panels/docks/FragmentTable.cpp, editor/panels/models/FragmentModel.cpp,
// editor/panels/models/FragmentProxyModel.cpp, editor/panels/models/FragmentMetrics.cpp,
// editor/panels/models/FragmentFilter.cpp and editor/document/FragmentSeeds.cpp.
#include "editor/document/FragmentSeeds.h"
#include "editor/document/FragmentVisibility.h"
#include "editor/panels/docks/FragmentTable.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Fragments.h"
#include "tests/support/asset/Projects.h"

#include <QAbstractItemModelTester>
#include <QAction>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QToolButton>

#include <optional>

using namespace rubble;

namespace {

using Column = FragmentColumn;

/// Seeds that cut the box into halves.
PlacedSeeds twoSeeds() { return {{{0, {0.25, 0.5}}, {1, {0.75, 0.5}}}}; }

Project projectOf(Asset asset) {
    Project project;
    project.nextId = 100;
    project.materials = {{.id = 1, .name = "stone", .density = 2000.0}};
    project.assets = {std::move(asset)};
    return project;
}

/// A document with its table in a window.
struct FragmentTableDesk {
    Document document;
    Selection selection;
    Bakes bakes;
    FragmentTable table{document, selection, bakes};
    QTableView& view = table.view();
    FragmentProxyModel& model = *table.findChild<FragmentProxyModel*>();
    const FragmentMetrics& metrics = table.findChild<FragmentModel*>()->metrics();
    QLineEdit& filter = *table.findChild<QLineEdit*>();
    std::optional<QAbstractItemModelTester> tester;  // none for many rows, as it reads all of them on each change

    explicit FragmentTableDesk(Asset asset) : document(projectOf(std::move(asset))) {
        selection.prune(document.project());
        rebake();
        if (bakes.find(document.project().assets[0].id)->bake->fragmentCount() < 1000) tester.emplace(&model);
        table.resize(700, 300);
        table.show();
        table.activateWindow();
        if (!QTest::qWaitForWindowActive(&table, kPatience)) qFatal("The window does not become active.");
        view.setFocus();
    }
    void rebake() {
        const auto asset = std::make_shared<const Asset>(document.project().assets.front());
        const auto result = std::make_shared<const Bake>(*bake(*asset));
        bakes.set(asset->id, std::make_shared<const BakedAsset>(BakedAsset{asset, result, {}, {}}));
    }
    void push(Asset asset) {
        const Id id = asset.id;
        document.push({.text = "Edit", .replacements = {Replacement<Asset>{id, std::move(asset)}}});
    }

    QString text(int row, Column column) const {
        return model.data(model.index(row, static_cast<int>(column)), Qt::DisplayRole).toString();
    }
    QStringList texts(Column column) const {
        QStringList texts;
        for (int row = 0; row < model.rowCount(); ++row) texts << text(row, column);
        return texts;
    }
    QString totals() const { return table.findChild<QLabel*>()->text().replace(QChar(QChar::Nbsp), ' '); }
    QStringList selectedIds() const {
        QStringList ids;
        for (const QModelIndex& index : view.selectionModel()->selectedRows()) ids << text(index.row(), Column::Name);
        ids.sort();
        return ids;
    }
    void click(int row, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mouseClick(view.viewport(), Qt::LeftButton, modifiers, view.visualRect(model.index(row, 1)).center());
    }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) { QTest::keyClick(&view, key, modifiers); }
    const Bake& currentBake() const { return *bakes.find(2)->bake; }
    bool isFaded(int row) const { return model.data(model.index(row, 0), Qt::ForegroundRole).isValid(); }
};

Asset boxOfTwo() { return boxAsset(2, 3, twoSeeds()); }
Asset boxOf(std::uint32_t count) { return boxAsset(2, 3, UniformScatter{.count = count}); }

/// Three columns, of which the first is fractured into two.
Asset boxOfLevels() {
    Asset asset = boxAsset(2, 3, PlacedSeeds{{{0, {0.2, 0.5}}, {1, {0.6, 0.5}}, {2, {0.8, 0.5}}}});
    asset.levels = {{.pattern = {{{.id = 4, .parameters = UniformScatter{.count = 2}}}}, .minimumVolume = 0.19}};
    return asset;
}

}  // namespace

class FragmentTableTest : public QObject {
    Q_OBJECT
private slots:
    void metricsOfABoxInHalves() {
        FragmentTableDesk desk(boxOfTwo());
        QCOMPARE(desk.texts(Column::Name), QStringList({"2/3.0", "2/3.1"}));
        for (int row = 0; row < 2; ++row) {
            QCOMPARE(desk.text(row, Column::Area), "0.5");
            QCOMPARE(desk.text(row, Column::Volume), "0.25");
            QCOMPARE(desk.text(row, Column::Mass), "500");
            QCOMPARE(desk.text(row, Column::Aspect), "2");
            QCOMPARE(desk.text(row, Column::Neighbours), "1");
            QCOMPARE(desk.text(row, Column::Level), "0");
        }
        QCOMPARE(desk.totals(), "Listed: 2 of 2, 0.5 m³, 1000 kg");
        const QVariant header = desk.model.headerData(2, Qt::Horizontal, Qt::DisplayRole);
        QCOMPARE(header.toString(), "Volume (m³)");
    }
    void valuesAreInThePreferredUnit() {
        FragmentTableDesk desk(boxOfTwo());
        desk.table.setUnits({LengthUnit::Centimetre});
        QCOMPARE(desk.text(0, Column::Area), "5000");
        QCOMPARE(desk.text(0, Column::Volume), "250000");
        QCOMPARE(desk.totals(), "Listed: 2 of 2, 500000 cm³, 1000 kg");
        desk.filter.setText("area < 5001");
        QCOMPARE(desk.model.rowCount(), 2);
        desk.filter.setText("area > 1 m²");
        QCOMPARE(desk.model.rowCount(), 0);
    }
    void massFollowsTheDensity() {
        FragmentTableDesk desk(boxOfTwo());
        Material stone = desk.document.project().materials[0];
        stone.density = 1000.0;
        desk.document.push({.text = "Set Density", .replacements = {Replacement<Material>{1, stone}}});
        QCOMPARE(desk.text(0, Column::Mass), "250");
        QCOMPARE(desk.totals(), "Listed: 2 of 2, 0.5 m³, 500 kg");
    }
    void childFragmentsFollowTheirParentAndCountOnce() {
        FragmentTableDesk desk(boxOfLevels());
        QCOMPARE(desk.texts(Column::Name), QStringList({"2/3.0", "2/3.0/4.0", "2/3.0/4.1", "2/3.1", "2/3.2"}));
        QCOMPARE(desk.texts(Column::Level), QStringList({"0", "1", "1", "0", "0"}));
        QCOMPARE(desk.totals(), "Listed: 5 of 5, 0.5 m³, 1000 kg");
        desk.filter.setText("level=1");
        QCOMPARE(desk.totals(), "Listed: 2 of 5, 0.2 m³, 400 kg");
    }
    void seedOfAFragmentIsThatOfItsAncestor() {
        const Bake bake = *rubble::bake(ringAsset());
        const std::vector<SeedId> seeds = seedsOfFragments(bake);
        QCOMPARE(seeds.size(), std::size_t{bake.fragmentCount()});
        for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) {
            const std::string start = "3/" + seeds[k].text();
            const std::string id = bake.fragmentId(k);
            QVERIFY2(id == start || id.starts_with(start + '.') || id.starts_with(start + '/'), id.c_str());
        }
    }
    void patternWithoutSeedsGivesOneFragment() {
        FragmentTableDesk desk(boxAsset(2, 3, PlacedSeeds{}));
        QCOMPARE(desk.model.rowCount(), 1);
        QCOMPARE(desk.text(0, Column::Neighbours), "0");
        QCOMPARE(desk.text(0, Column::Aspect), "1");
    }

    void everyColumnSortsNumerically() {
        FragmentTableDesk desk(boxOf(200));
        for (int column = 0; column < kFragmentColumns; ++column) {
            for (const Qt::SortOrder order : {Qt::AscendingOrder, Qt::DescendingOrder}) {
                desk.view.sortByColumn(column, order);
                for (int row = 1; row < desk.model.rowCount(); ++row) {
                    const std::uint32_t before = desk.model.fragmentAt(row - 1), after = desk.model.fragmentAt(row);
                    const double step =
                        desk.metrics.value(Column(column), after) - desk.metrics.value(Column(column), before);
                    QVERIFY(order == Qt::AscendingOrder ? step >= 0.0 : step <= 0.0);
                    QVERIFY(step != 0.0 || before < after);
                }
            }
        }
    }
    void sortingKeepsTheSelection() {
        FragmentTableDesk desk(boxOf(50));
        desk.click(3);
        const QStringList selected = desk.selectedIds();
        QHeaderView* header = desk.view.horizontalHeader();
        QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, {header->sectionViewportPosition(2) + 20, 5});
        QCOMPARE(header->sortIndicatorSection(), 2);
        QVERIFY(desk.text(0, Column::Volume).toDouble() < desk.text(49, Column::Volume).toDouble());
        QCOMPARE(desk.selectedIds(), selected);
    }

    void filterLimitsTheRows_data() {
        QTest::addColumn<QString>("filter");
        QTest::addColumn<QStringList>("ids");
        const QStringList all{"2/3.0", "2/3.0/4.0", "2/3.0/4.1", "2/3.1", "2/3.2"};
        QTest::newRow("nothing") << "  " << all;
        QTest::newRow("text") << "/4" << QStringList{"2/3.0/4.0", "2/3.0/4.1"};
        QTest::newRow("texts") << "/4 .1" << QStringList{"2/3.0/4.1"};
        QTest::newRow("range") << "area >= 0.3 area<0.4" << QStringList{"2/3.1", "2/3.2"};
        QTest::newRow("equal up to rounding") << "AREA = 0.4" << QStringList{"2/3.0"};
        QTest::newRow("not equal") << "level≠0" << QStringList{"2/3.0/4.0", "2/3.0/4.1"};
        QTest::newRow("short name and unit") << "m > 399 kg vol ≤ 0.2 m³" << QStringList{"2/3.0"};
        QTest::newRow("unit") << "area<=0.3m² 3.1" << QStringList{"2/3.1"};
        QTest::newRow("unit apart") << "area <= 3000 cm² 3.1" << QStringList{"2/3.1"};
        QTest::newRow("condition after a bare number") << "level = 0 neighbours > 1" << QStringList{"2/3.1"};
    }
    void filterLimitsTheRows() {
        QFETCH(QString, filter);
        QFETCH(QStringList, ids);
        FragmentTableDesk desk(boxOfLevels());
        desk.filter.setText(filter);
        QCOMPARE(desk.texts(Column::Name), ids);
    }
    void invalidFilterIsReportedAndKeepsTheRows_data() {
        QTest::addColumn<QString>("filter");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("column") << "size < 2"
                                << "There is no column \"size\". Use one of area, volume, mass, aspect, neighbours, "
                                   "level, problems.";
        QTest::newRow("several") << "a < 2"
                                 << "Column \"a\" is ambiguous: it may be one of area, aspect.";
        QTest::newRow("no column") << "< 2"
                                   << "Enter the name of a column before \"<\".";
        QTest::newRow("no number") << "area <"
                                   << "Enter a number after \"area <\".";
        QTest::newRow("two operators") << "area < < 2"
                                       << "Enter a number after \"area <\".";
        QTest::newRow("number") << "area < x2"
                                << "\"x2\" after \"area <\" is not a number.";
        QTest::newRow("operator") << "area =< 2"
                                  << "\"=<\" is not a comparison. Use one of < <= = != >= >.";
    }
    void invalidFilterIsReportedAndKeepsTheRows() {
        QFETCH(QString, filter);
        QFETCH(QString, sentence);
        FragmentTableDesk desk(boxOfTwo());
        desk.filter.setText("3.1");
        desk.filter.setText(filter);
        QCOMPARE(desk.totals(), sentence);
        QCOMPARE(desk.texts(Column::Name), QStringList{"2/3.1"});
        desk.filter.clear();
        QCOMPARE(desk.model.rowCount(), 2);
    }
    void numbersAreInTheLocalesDigits() {
        const QLocale before;
        QLocale::setDefault(QLocale(QLocale::German, QLocale::Germany));
        const Result<FragmentFilter> filter = fragmentFilter("area < 0,25", {}, QLocale());
        QLocale::setDefault(before);
        QVERIFY(filter && filter->conditions[0].bound == 0.25);
    }

    void selectingRowsSelectsFragmentsAndSeeds() {
        FragmentTableDesk desk(boxOfLevels());
        desk.click(3);
        QVERIFY((desk.selection.fragments() == FragmentSelection{{{3, 1}}, std::nullopt}));
        desk.click(4, Qt::ControlModifier);
        QVERIFY((desk.selection.fragments() == FragmentSelection{{{3, 1}, {3, 2}}, std::nullopt}));
        desk.click(1);  // a child fragment by itself
        QVERIFY((desk.selection.fragments() == FragmentSelection{{{3, 0}}, {{"2/3.0/4.0"}}}));
        QCOMPARE(desk.selectedIds(), QStringList("2/3.0/4.0"));
        desk.click(0, Qt::ControlModifier);
        desk.click(2, Qt::ControlModifier);  // now all fragments of the seed
        QVERIFY((desk.selection.fragments() == FragmentSelection{{{3, 0}}, std::nullopt}));
        desk.click(2, Qt::ControlModifier);
        QCOMPARE(desk.selectedIds(), QStringList({"2/3.0", "2/3.0/4.0"}));
        desk.click(0);
        desk.click(3, Qt::ShiftModifier);
        QVERIFY((desk.selection.seeds() == Selection::Seeds{{3, 0}, {3, 1}}));
        desk.key(Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(desk.selection.seeds().size(), std::size_t{3});
    }
    void selectedSeedsAreSelectedAndScrolledTo() {
        FragmentTableDesk desk(boxOf(300));
        desk.selection.setSeeds({{3, 250}, {3, 270}});
        QCOMPARE(desk.selectedIds(), QStringList({"2/3.250", "2/3.270"}));
        QVERIFY(desk.view.viewport()->rect().contains(desk.view.visualRect(desk.model.index(250, 0)).center()));
        QVERIFY(desk.totals().contains("Selected: 2, "));
        desk.selection.setSeeds({});
        QVERIFY(desk.selectedIds().empty());
    }
    void rebakeKeepsSelectionAndScrollPosition() {
        FragmentTableDesk desk(boxOf(300));
        desk.view.sortByColumn(1, Qt::DescendingOrder);
        desk.selection.setSeeds({{3, 7}});
        desk.view.verticalScrollBar()->setValue(120);
        const int scroll = desk.view.verticalScrollBar()->value();
        Asset asset = boxOf(300);
        asset.pattern.layers[0].overrides = {{.index = 9, .position = {0.5, 0.5}}};
        desk.push(asset);
        desk.rebake();
        QCOMPARE(desk.selectedIds(), QStringList{"2/3.7"});
        QCOMPARE(desk.view.verticalScrollBar()->value(), scroll);
        QVERIFY(desk.text(0, Column::Area).toDouble() > desk.text(299, Column::Area).toDouble());
    }

    void hiddenFragmentsAreFaded() {
        FragmentTableDesk desk(boxOfLevels());
        desk.click(1);
        hideSelected(desk.selection, desk.currentBake());
        QVERIFY((desk.selection.hidden() == FragmentSelection{{{3, 0}}, {{"2/3.0/4.0"}}}));
        QVERIFY(desk.selection.seeds().empty());
        QVERIFY(!desk.isFaded(0) && desk.isFaded(1) && !desk.isFaded(2));
        desk.click(2);
        hideSelected(desk.selection, desk.currentBake());  // with all children hidden the parent is hidden, too
        QVERIFY((desk.selection.hidden() == FragmentSelection{{{3, 0}}, std::nullopt}));
        QVERIFY(desk.isFaded(0) && desk.isFaded(2) && !desk.isFaded(3));
        desk.click(3);
        isolateSelected(desk.selection, desk.currentBake());
        QVERIFY((desk.selection.hidden() == FragmentSelection{{{3, 0}, {3, 2}}, std::nullopt}));
        desk.key(Qt::Key_I, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY((desk.selection.seeds() == Selection::Seeds{{3, 0}, {3, 2}}));
        desk.table.showSelected();
        QVERIFY(desk.selection.hidden().isEmpty());
        hideSelected(desk.selection, desk.currentBake());
        QVERIFY(desk.isFaded(0));
        showAllFragments(desk.selection);
        QVERIFY(!desk.isFaded(0));
    }
    void visibilityActionsHaveShortcutsAndButtons() {
        QAction hide("&Hide");
        hide.setShortcuts({QKeySequence("H"), QKeySequence("/")});
        hide.setShortcutContext(Qt::WidgetShortcut);
        QSignalSpy triggered(&hide, &QAction::triggered);
        FragmentTableDesk desk(boxOfTwo());
        desk.table.setFragmentActions({&hide}, {});
        desk.key(Qt::Key_H);
        QCOMPARE(triggered.count(), 1);
        desk.key(Qt::Key_Slash);
        QCOMPARE(triggered.count(), 2);
        for (QToolButton* button : desk.table.findChildren<QToolButton*>()) {
            if (button->defaultAction() == &hide) QTest::mouseClick(button, Qt::LeftButton);
        }
        QCOMPARE(triggered.count(), 3);
        hide.setEnabled(false);
        desk.key(Qt::Key_H);
        QCOMPARE(triggered.count(), 3);
    }
    void invertingAffectsListedFragmentsOnly() {
        FragmentTableDesk desk(boxOfLevels());
        desk.filter.setText("area < 0.35");
        desk.selection.setSeeds({{3, 1}});
        desk.table.invertSelection();  // of the first column only the children are listed
        QVERIFY((desk.selection.seeds() == Selection::Seeds{{3, 0}, {3, 2}}));
        QCOMPARE(desk.selectedIds(), QStringList({"2/3.0/4.0", "2/3.0/4.1", "2/3.2"}));
    }
    void missingBakeIsReported() {
        FragmentTableDesk desk(boxOfTwo());
        desk.bakes.clear();
        QCOMPARE(desk.totals(), "Baking…");
        const Error fault{ErrorCode::Crossing, "The outline crosses itself."};
        desk.bakes.set(2, std::make_shared<const BakedAsset>(BakedAsset{nullptr, nullptr, fault, {}}));
        QCOMPARE(desk.totals(), "The outline crosses itself.");
        QCOMPARE(desk.model.rowCount(), 0);
    }
    void hiddenTableComputesNothing() {
        FragmentTableDesk desk(boxOfTwo());
        desk.table.hide();
        desk.push(boxOf(5));
        desk.rebake();
        QCOMPARE(desk.model.rowCount(), 2);
        desk.table.show();
        QCOMPARE(desk.model.rowCount(), 5);
    }
    void fiftyThousandRowsSortAndFilter() {
        FragmentTableDesk desk(boxOf(50'000));
        QCOMPARE(desk.model.rowCount(), 50'000);
        desk.view.sortByColumn(1, Qt::AscendingOrder);
        Selection::Seeds odd;
        for (std::uint32_t index = 1; index < 50'000; index += 2) odd.insert({3, index});
        desk.selection.setSeeds(odd);
        int selectedRows = 0;
        for (const QItemSelectionRange& range : desk.view.selectionModel()->selection()) selectedRows += range.height();
        QCOMPARE(selectedRows, 25'000);
        hideSelected(desk.selection, desk.currentBake());
        desk.filter.setText("99 neighbours > 6");
        QVERIFY(desk.model.rowCount() > 0);
        desk.key(Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(desk.selection.seeds().size(), std::size_t(desk.model.rowCount()));
    }
};

RUBBLE_TEST_WITH(FragmentTableTest, QApplication)
#include "FragmentTableTest.moc"
