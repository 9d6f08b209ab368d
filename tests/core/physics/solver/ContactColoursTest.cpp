#include "core/base/Random.h"
#include "core/physics/solver/ContactColours.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <set>

using namespace rubble;

namespace {

struct Kept {
    std::uint32_t contact, first, second;
    ContactSlot slot;
};

/// Verifies that no two contacts of a colour share a dynamic body, and that every contact is in its slot.
bool isSound(const ContactColours& colours, const std::vector<Kept>& kept, std::uint32_t fixedBodies) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> seen;  // colour and body
    for (const Kept& one : kept) {
        const ContactBlock& block = colours.block(one.slot);
        const auto lane = static_cast<std::size_t>(ContactColours::laneOf(one.slot));
        if (block.contact[lane] != one.contact || block.first[lane] != one.first || block.second[lane] != one.second)
            return false;
        if (one.slot.list == ContactColours::kOverflow) continue;
        for (std::uint32_t body : {one.first, one.second}) {
            if (body > fixedBodies && !seen.insert({ContactColours::colourOf(one.slot.list), body}).second)
                return false;
        }
    }
    return colours.contactCount() == kept.size();
}

}  // namespace

class ContactColoursTest : public QObject {
    Q_OBJECT
private slots:
    void contactsOfAColourShareNoBody() {
        constexpr std::uint32_t kFixed = 3;  // bodies 1 to 3
        Random random(11);
        ContactColours colours;
        colours.resizeBodies(60);
        std::vector<Kept> kept;
        for (std::uint32_t round = 0; round < 3000; ++round) {
            if (random.below(3) > 0 || kept.empty()) {
                const auto first = 1 + static_cast<std::uint32_t>(random.below(30));
                const auto second = 31 + static_cast<std::uint32_t>(random.below(29));
                kept.push_back(
                    {round, first, second, colours.add(round, first, first > kFixed, second, true, 1 + round % 4)});
            } else if (random.below(2) == 0) {
                Kept& one = kept[random.below(kept.size())];
                if (one.slot.list == ContactColours::kOverflow) continue;
                const ContactSlot left = one.slot;
                const std::uint32_t moved = colours.moveToOtherList(one.slot);
                for (Kept& other : kept) {
                    if (other.contact == moved) other.slot = left;
                }
            } else {
                const std::size_t place = random.below(kept.size());
                const Kept gone = kept[place];
                const std::uint32_t moved = colours.remove(gone.slot, gone.first > kFixed, true);
                kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(place));
                for (Kept& one : kept) {
                    if (one.contact == moved) one.slot = gone.slot;
                }
            }
            QVERIFY(isSound(colours, kept, kFixed));
        }
    }
    void contactsAreSortedByCell() {
        constexpr std::uint32_t kBodies = 400, kCells = 5;
        Random random(12);
        ContactColours colours;
        colours.resizeBodies(2 * kBodies + 1);
        std::vector<Kept> kept;
        for (std::uint32_t contact = 0; contact < 900; ++contact) {
            const auto first = 1 + static_cast<std::uint32_t>(random.below(kBodies));
            const auto second = kBodies + 1 + static_cast<std::uint32_t>(random.below(kBodies));
            kept.push_back({contact, first, second, colours.add(contact, first, true, second, true, 1 + contact % 4)});
        }
        const auto cellOf = [](std::uint32_t first, std::uint32_t) -> std::size_t { return first % kCells; };
        for (std::uint32_t list = 0; list < ContactColours::kOverflow; ++list) {
            const ContactColours::CellEnds ends = colours.sort(
                list, kCells, cellOf, [&](std::uint32_t contact, ContactSlot slot) { kept[contact].slot = slot; });
            for (const Kept& one : kept) {
                if (one.slot.list != list) continue;
                const std::size_t cell = cellOf(one.first, one.second);
                QVERIFY(one.slot.index < ends[cell]);
                QVERIFY(cell == 0 || one.slot.index >= ends[cell - 1]);
            }
        }
        QVERIFY(isSound(colours, kept, 0));
    }
    void contactsWithFixedBodiesAreSolvedLast() {
        ContactColours colours;
        colours.resizeBodies(4);
        const ContactSlot free = colours.add(0, 1, true, 2, true, 4), fixed = colours.add(1, 1, true, 3, false, 4);
        QVERIFY(ContactColours::colourOf(free.list) < ContactColours::kBetweenBodies);
        QVERIFY(ContactColours::colourOf(fixed.list) >= ContactColours::kBetweenBodies);
    }
    void excessContactsOfABodyAreOverflow() {
        ContactColours colours;
        colours.resizeBodies(102);
        std::uint32_t oneByOne = 0;
        for (std::uint32_t i = 0; i < 100; ++i)
            oneByOne += colours.add(i, 1, true, 2 + i, true, 4).list == ContactColours::kOverflow;
        QCOMPARE(oneByOne, 100 - ContactColours::kBetweenBodies);
    }
};

RUBBLE_TEST(ContactColoursTest)
#include "ContactColoursTest.moc"
