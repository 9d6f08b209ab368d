#include "core/io/exchange/UsdWriter.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class UsdWriterTest : public QObject {
    Q_OBJECT
private slots:
    void primsAreNestedAndIndented() {
        UsdWriter lines("a", "b");
        QCOMPARE(lines.begin("Xform", "a"), std::string("/a"));
        QCOMPARE(lines.begin("Mesh", "m", {"One", "Two"}), std::string("/a/m"));
        lines.addOutput("token outputs:surface");
        lines.setPoints("point3f[] points", std::vector<Vec3>{{0.1, -0.0, 2.0}, {1.0, 0.5, 1e-7}});
        lines.setPoints("texCoord2f[] primvars:st", std::vector<Vec2>{{0.0, 1.0}}, UsdInterpolation::FaceVarying);
        lines.setIndices("int[] indices", std::vector<std::uint32_t>{3, 1});
        lines.setRotation("quatf q", Quat(1.0, 0.0, 0.5, 0.0));
        lines.end();
        lines.setDoubles("double3 xformOp:translate", {0.1, 1.0 / 3.0, 0.0});
        lines.setFloat("float f", 1.0 / 3.0);
        lines.setTarget("rel r", "/a/m");
        lines.setAsset("asset file", "a.png");
        lines.setTexts("uniform token[] xformOpOrder", {"x", "y"});
        lines.end();
        QCOMPARE(std::move(lines).text(), std::string(R"(#usda 1.0
(
    defaultPrim = "a"
    doc = "b"
    kilogramsPerUnit = 1
    metersPerUnit = 1
    upAxis = "Y"
)

def Xform "a"
{

    def Mesh "m" (
        prepend apiSchemas = ["One", "Two"]
    )
    {
        token outputs:surface
        point3f[] points = [(0.1, 0, 2), (1, 0.5, 1e-07)]
        texCoord2f[] primvars:st = [(0, 1)] (interpolation = "faceVarying")
        int[] indices = [3, 1]
        quatf q = (1, 0, 0.5, 0)
    }
    double3 xformOp:translate = (0.1, 0.3333333333333333, 0)
    float f = 0.33333334
    rel r = </a/m>
    asset file = @./a.png@
    uniform token[] xformOpOrder = ["x", "y"]
}
)"));
    }
    void textIsQuoted() {
        UsdWriter lines("a", "");
        lines.begin("Scope", "a");
        lines.setText("string s", "a \"b\" \\ \n\x01 \xc3\xa4 \xff");
        lines.end();
        QVERIFY(std::move(lines).text().find("string s = \"a \\\"b\\\" \\\\ \\n\\x01 \xc3\xa4 \xef\xbf\xbd\"\n") !=
                std::string::npos);
    }
    void namesAreUniqueIdentifiersOfAscii() {
        UsdNames names;
        QCOMPARE(names.unique("wall_f3"), std::string("wall_f3"));
        QCOMPARE(names.unique("W\xc3\xa4nd"), std::string("W_nd"));
        QCOMPARE(names.unique("W\xc3\xb6nd"), std::string("W_nd_2"));
        QCOMPARE(names.unique("W\xc3\xb6nd"), std::string("W_nd_3"));
        QCOMPARE(names.unique("3 tiles"), std::string("_3_tiles"));
        QCOMPARE(names.unique(""), std::string("_"));
    }
};

RUBBLE_TEST(UsdWriterTest)
#include "UsdWriterTest.moc"
