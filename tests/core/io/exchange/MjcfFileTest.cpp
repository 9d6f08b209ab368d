#include "core/io/exchange/MjcfFile.h"
#include "core/io/text/NumberText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Packs.h"

#include <QTest>
#include <QXmlStreamReader>

#include <map>

using namespace rubble;

namespace {

const Material kMjcfBrick = heavyBrick();  // packs borrow it

/// An element's attributes.
using XmlAttributes = std::map<std::string, std::string>;

/// All elements of a well-formed document by name, in order; nothing of another.
std::map<std::string, std::vector<XmlAttributes>> elementsOf(const std::string& text) {
    std::map<std::string, std::vector<XmlAttributes>> elements;
    QXmlStreamReader xml(QByteArray::fromStdString(text));
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        XmlAttributes& attributes = elements[xml.name().toString().toStdString()].emplace_back();
        for (const QXmlStreamAttribute& one : xml.attributes())
            attributes[one.name().toString().toStdString()] = one.value().toString().toStdString();
    }
    if (xml.hasError()) return {};
    return elements;
}

std::string vectorText(Vec3 v) { return numberText(v.x) + " " + numberText(v.y) + " " + numberText(v.z); }

std::string mjcfOf(const Asset& asset, std::vector<std::uint32_t>& leaves, Pack& pack) {
    const Bake baked = bake(asset).value();
    const PackInput input{baked, asset, kMjcfBrick, packNames(asset), {}};
    pack = packOf(input, {});
    leaves.clear();
    for (std::uint32_t k = 0; k < pack.fragments.size(); ++k) {
        if (pack.fragments[k].childCount == 0) leaves.push_back(k);
    }
    return mjcfFile(PackBuilder(input), leaves).value();
}

}  // namespace

class MjcfFileTest : public QObject {
    Q_OBJECT
private slots:
    void bodiesAreThoseOfThePack() {
        std::vector<std::uint32_t> leaves;
        Pack pack;
        auto elements = elementsOf(mjcfOf(twoLevelRing(), leaves, pack));
        QCOMPARE(elements["body"].size(), leaves.size());
        QCOMPARE(elements["freejoint"].size(), leaves.size());
        QCOMPARE(elements["inertial"].size(), leaves.size());
        std::size_t hulls = 0;
        for (std::size_t k = 0; k < leaves.size(); ++k) {
            const PackBody& body = pack.fragments[leaves[k]];
            QCOMPARE(elements["body"][k]["name"], body.name);
            QCOMPARE(elements["body"][k]["pos"], vectorText(body.offset));
            XmlAttributes& inertial = elements["inertial"][k];
            const Quat& rotation = body.principal->rotation;
            QCOMPARE(inertial["mass"], numberText(body.mass));
            QCOMPARE(inertial["diaginertia"], vectorText(body.principal->moments));
            QCOMPARE(inertial["quat"], numberText(rotation.w) + " " + vectorText({rotation.x, rotation.y, rotation.z}));
            for (const PackHull& hull : body.hulls) {
                std::string vertices;
                for (const Vec3& vertex : hull.polytope.vertices)
                    vertices += (vertices.empty() ? "" : "  ") + vectorText(vertex);
                QCOMPARE(elements["mesh"][hulls]["vertex"], vertices);
                XmlAttributes& geom = elements["geom"][hulls + 1];
                QCOMPARE(geom["mesh"], elements["mesh"][hulls]["name"]);
                QCOMPARE(geom["friction"], numberText(kMjcfBrick.friction));
                ++hulls;
            }
        }
        QCOMPARE(elements["mesh"].size(), hulls);
        QCOMPARE(elements["geom"].size(), hulls + 1);
        const PackBody& whole = pack.whole;
        QCOMPARE(elements["geom"][0]["pos"], "0 " + numberText(whole.offset.y + whole.bounds->min.y) + " 0");
        QCOMPARE(elements["option"][0]["impratio"], std::string("100"));
        QCOMPARE(numberText(1.0 / 240.0), elements["option"][0]["timestep"]);
    }
    /// MuJoCo refuses moments of 1e-15 kg·m² or less.
    void momentsOfSliversAreRaised() {
        Asset speck = twoLevelRing();
        for (Vec2& corner : speck.prism().outline.outer) corner *= 1e-4;
        for (Ring& hole : speck.prism().outline.holes)
            for (Vec2& corner : hole) corner *= 1e-4;
        speck.prism().depth *= 1e-4;
        std::vector<std::uint32_t> leaves;
        Pack pack;
        const std::string text = mjcfOf(speck, leaves, pack);
        QVERIFY(std::ranges::all_of(pack.fragments,
                                    [](const PackBody& body) { return body.principal->moments.x < 1e-15; }));
        QVERIFY(text.find("diaginertia=\"1e-14 1e-14 1e-14\"") != std::string::npos);
    }
    void namesAreEscaped() {
        std::vector<std::uint32_t> leaves;
        Pack pack;
        Asset asset = twoLevelRing();
        asset.name = "M\xc3\xb6rtel <\"&\">";
        auto elements = elementsOf(mjcfOf(asset, leaves, pack));
        QCOMPARE(elements["mujoco"].size(), std::size_t{1});
        QCOMPARE(elements["mujoco"][0]["model"], asset.name);
    }
    void bytesAreTheSame() {
        std::vector<std::uint32_t> leaves;
        Pack pack;
        QVERIFY(mjcfOf(bondedRing(), leaves, pack) == mjcfOf(bondedRing(), leaves, pack));
    }
    void cancelled() {
        const Asset asset = twoLevelRing();
        const Bake baked = bake(asset).value();
        const PackBuilder builder(PackInput{baked, asset, kMjcfBrick, packNames(asset), {}});
        const TaskContext task;
        task.cancel.cancel();
        const std::vector<std::uint32_t> bodies{0};
        const Result<std::string> file = mjcfFile(builder, bodies, task);
        QVERIFY(!file && file.error().code == ErrorCode::Cancelled);
    }
};

RUBBLE_TEST(MjcfFileTest)
#include "MjcfFileTest.moc"
