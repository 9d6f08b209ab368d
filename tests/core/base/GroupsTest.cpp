#include "core/base/Groups.h"

#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class GroupsTest : public QObject {
    Q_OBJECT
private slots:
    void itemsAreInTheirGroupsInOrder() {
        const std::vector<std::uint32_t> groupOf = {2, 0, 2, 3, 0, 2};
        const Groups<int> groups = grouped<int>(5, [&](const auto& visit) {
            for (int item = 0; item < 6; ++item) visit(groupOf[static_cast<std::size_t>(item)], item);
        });
        const auto of = [&](std::size_t group) {
            return std::vector(groups.of(group).begin(), groups.of(group).end());
        };
        QCOMPARE(of(0), (std::vector{1, 4}));
        QCOMPARE(of(1), std::vector<int>());
        QCOMPARE(of(2), (std::vector{0, 2, 5}));
        QCOMPARE(of(3), std::vector{3});
        QCOMPARE(of(4), std::vector<int>());
    }
    void partsOnThreadsGiveTheSame() {
        const auto groupOf = [](std::uint32_t item) { return item * 7 % 10; };
        const Groups<std::uint32_t> whole = grouped<std::uint32_t>(10, [&](const auto& visit) {
            for (std::uint32_t item = 0; item < 100; ++item) visit(groupOf(item), item);
        });
        const Groups<std::uint32_t> parts = grouped<std::uint32_t>(10, 4, 2, [&](std::size_t part, const auto& visit) {
            const IndexRange range = chunkRange(100, part, 4);
            for (std::size_t k = range.begin; k < range.end; ++k) {
                visit(groupOf(static_cast<std::uint32_t>(k)), static_cast<std::uint32_t>(k));
            }
        });
        QVERIFY(whole.first == parts.first && whole.items == parts.items);
    }
    void noItemsMakeEmptyGroups() {
        const Groups<int> groups = grouped<int>(2, [](const auto&) {});
        QVERIFY(groups.of(0).empty() && groups.of(1).empty());
        QCOMPARE(grouped<int>(0, [](const auto&) {}).first.size(), std::size_t{1});
    }
};

RUBBLE_TEST(GroupsTest)
#include "GroupsTest.moc"
