<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>ContactSheet</name>
    <message numerus="yes">
        <source>%Ln fragment(s)</source>
        <translation>
            <numerusform>%Ln fragment</numerusform>
            <numerusform>%Ln fragments</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln merge(s) or split(s)</source>
        <translation>
            <numerusform>%Ln merge or split</numerusform>
            <numerusform>%Ln merges or splits</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln pattern(s) of single fragments</source>
        <translation>
            <numerusform>%Ln pattern of single fragments</numerusform>
            <numerusform>%Ln patterns of single fragments</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln threshold(s) of single fragments</source>
        <translation>
            <numerusform>%Ln threshold of single fragments</numerusform>
            <numerusform>%Ln thresholds of single fragments</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln fragment(s) that never break</source>
        <translation>
            <numerusform>%Ln fragment that never breaks</numerusform>
            <numerusform>%Ln fragments that never break</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln cluster(s) of fragments</source>
        <translation>
            <numerusform>%Ln cluster of fragments</numerusform>
            <numerusform>%Ln clusters of fragments</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Export</name>
    <message numerus="yes">
        <source>Files in the %n folder(s) %1 were changed after the last export.</source>
        <translation>
            <numerusform>Files in the folder %1 were changed after the last export.</numerusform>
            <numerusform>Files in the folders %1 were changed after the last export.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Exported %n asset(s) to %1</source>
        <translation>
            <numerusform>Exported %n asset to %1</numerusform>
            <numerusform>Exported %n assets to %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more asset(s) could not be exported.</source>
        <translation>
            <numerusform>%n more asset could not be exported.</numerusform>
            <numerusform>%n more assets could not be exported.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>HighlightPainting</name>
    <message numerus="yes">
        <source>%Ln neighbour(s)</source>
        <translation>
            <numerusform>%Ln neighbour</numerusform>
            <numerusform>%Ln neighbours</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>InstanceEdits</name>
    <message numerus="yes">
        <source>Hide %n Instance(s)</source>
        <translation>
            <numerusform>Hide Instance</numerusform>
            <numerusform>Hide %n Instances</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Lock %n Instance(s)</source>
        <translation>
            <numerusform>Lock Instance</numerusform>
            <numerusform>Lock %n Instances</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Anchor %n Instance(s)</source>
        <translation>
            <numerusform>Anchor %n Instance</numerusform>
            <numerusform>Anchor %n Instances</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Release %n Instance(s)</source>
        <translation>
            <numerusform>Release %n Instance</numerusform>
            <numerusform>Release %n Instances</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MaterialSummary</name>
    <message numerus="yes">
        <source>where it is hit, into %Ln fragment(s)</source>
        <translation>
            <numerusform>where it is hit, into %Ln fragment</numerusform>
            <numerusform>where it is hit, into %Ln fragments</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ProjectEdits</name>
    <message numerus="yes">
        <source>Delete %n Asset(s)</source>
        <translation>
            <numerusform>Delete Asset</numerusform>
            <numerusform>Delete %n Assets</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Duplicate %n Instance(s)</source>
        <translation>
            <numerusform>Duplicate Instance</numerusform>
            <numerusform>Duplicate %n Instances</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Delete %n Instance(s)</source>
        <translation>
            <numerusform>Delete Instance</numerusform>
            <numerusform>Delete %n Instances</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>SelectedSeedEdits</name>
    <message numerus="yes">
        <source>Delete %n Seed(s)</source>
        <translation>
            <numerusform>Delete Seed</numerusform>
            <numerusform>Delete %n Seeds</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::AssetPage</name>
    <message numerus="yes">
        <source>%Ln point(s)</source>
        <translation>
            <numerusform>%Ln point</numerusform>
            <numerusform>%Ln points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln hole(s)</source>
        <translation>
            <numerusform>%Ln hole</numerusform>
            <numerusform>%Ln holes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangle(s)</source>
        <translation>
            <numerusform>%Ln triangle</numerusform>
            <numerusform>%Ln triangles</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::BondSection</name>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>%Ln stroke</numerusform>
            <numerusform>%Ln strokes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::ClusterSection</name>
    <message numerus="yes">
        <source>%Ln cluster(s)</source>
        <translation>
            <numerusform>%Ln cluster</numerusform>
            <numerusform>%Ln clusters</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::ContactSheetWindow</name>
    <message numerus="yes">
        <source>%Ln seed(s) locked in all new variants.</source>
        <translation>
            <numerusform>%Ln seed locked in all new variants.</numerusform>
            <numerusform>%Ln seeds locked in all new variants.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%L1 of %Ln variant(s)</source>
        <translation>
            <numerusform>%L1 of %Ln variant</numerusform>
            <numerusform>%L1 of %Ln variants</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln variant(s)</source>
        <translation>
            <numerusform>%Ln variant</numerusform>
            <numerusform>%Ln variants</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::EventActions</name>
    <message numerus="yes">
        <source>Exported %Ln event(s) to %1.</source>
        <translation>
            <numerusform>Exported %Ln event to %1.</numerusform>
            <numerusform>Exported %Ln events to %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::EventText</name>
    <message numerus="yes">
        <source>%1 broke into %Ln fragment(s)</source>
        <translation>
            <numerusform>%1 broke into %Ln fragment</numerusform>
            <numerusform>%1 broke into %Ln fragments</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 broke into %Ln fragment(s), hit by %2</source>
        <translation>
            <numerusform>%1 broke into %Ln fragment, hit by %2</numerusform>
            <numerusform>%1 broke into %Ln fragments, hit by %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln bond(s) of %1 broke</source>
        <translation>
            <numerusform>%Ln bond of %1 broke</numerusform>
            <numerusform>%Ln bonds of %1 broke</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln break(s)</source>
        <translation>
            <numerusform>%Ln break</numerusform>
            <numerusform>%Ln breaks</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln broken bond(s)</source>
        <translation>
            <numerusform>%Ln broken bond</numerusform>
            <numerusform>%Ln broken bonds</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::FragmentActions</name>
    <message numerus="yes">
        <source>%Ln fragment(s) fractured · Double-click one, or select it and press %1, to edit its pattern</source>
        <translation>
            <numerusform>%Ln fragment fractured · Double-click one, or select it and press %1, to edit its pattern</numerusform>
            <numerusform>%Ln fragments fractured · Double-click one, or select it and press %1, to edit its pattern</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::FragmentSection</name>
    <message numerus="yes">
        <source>%Ln selected fragment(s) break further.</source>
        <translation>
            <numerusform>%Ln selected fragment breaks further.</numerusform>
            <numerusform>%Ln selected fragments break further.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::ImportDialog</name>
    <message numerus="yes">
        <source>%Ln object(s)</source>
        <translation>
            <numerusform>%Ln object</numerusform>
            <numerusform>%Ln objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln triangle(s)</source>
        <translation>
            <numerusform>%Ln triangle</numerusform>
            <numerusform>%Ln triangles</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Import %Ln refused object(s) in this way</source>
        <translation>
            <numerusform>Import %Ln refused object in this way</numerusform>
            <numerusform>Import %Ln refused objects in this way</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln separate part(s)</source>
        <translation>
            <numerusform>%Ln separate part</numerusform>
            <numerusform>%Ln separate parts</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln cavity(s)</source>
        <translation>
            <numerusform>%Ln cavity</numerusform>
            <numerusform>%Ln cavities</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::MainWindow</name>
    <message numerus="yes">
        <source>%Ln seed(s)</source>
        <translation>
            <numerusform>%Ln seed</numerusform>
            <numerusform>%Ln seeds</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln fragment(s)</source>
        <translation>
            <numerusform>%Ln fragment</numerusform>
            <numerusform>%Ln fragments</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::MaterialDialog</name>
    <message numerus="yes">
        <source>Apply the fracture &amp;pattern in place of %n layer(s)</source>
        <translation>
            <numerusform>Apply the fracture &amp;pattern in place of %n layer</numerusform>
            <numerusform>Apply the fracture &amp;pattern in place of %n layers</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::MeshSeedsDialog</name>
    <message numerus="yes">
        <source>%Ln seed(s).</source>
        <translation>
            <numerusform>%Ln seed.</numerusform>
            <numerusform>%Ln seeds.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::MortarSection</name>
    <message numerus="yes">
        <source>%Ln joint(s) of fragments</source>
        <translation>
            <numerusform>%Ln joint of fragments</numerusform>
            <numerusform>%Ln joints of fragments</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 between %Ln pair(s) of instances, %2 together.</source>
        <translation>
            <numerusform>%1 between %Ln pair of instances, %2 together.</numerusform>
            <numerusform>%1 between %Ln pairs of instances, %2 together.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::OutlineModel</name>
    <message numerus="yes">
        <source>Delete %n Point(s)</source>
        <translation>
            <numerusform>Delete Point</numerusform>
            <numerusform>Delete %n Points</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::PlayPanel</name>
    <message numerus="yes">
        <source>%Ln event(s)</source>
        <translation>
            <numerusform>%Ln event</numerusform>
            <numerusform>%Ln events</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::PlayTestForm</name>
    <message numerus="yes">
        <source>%1 (%n fragment(s))</source>
        <translation>
            <numerusform>%1 (%n fragment)</numerusform>
            <numerusform>%1 (%n fragments)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::PlayView</name>
    <message numerus="yes">
        <source>Without %1, %Ln bodies would fall: %2</source>
        <translation>
            <numerusform>Without %1, %Ln body would fall: %2</numerusform>
            <numerusform>Without %1, %Ln bodies would fall: %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::ProblemModel</name>
    <message numerus="yes">
        <source>%Ln hull(s)</source>
        <translation>
            <numerusform>%Ln hull</numerusform>
            <numerusform>%Ln hulls</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln seed(s)</source>
        <translation>
            <numerusform>%Ln seed</numerusform>
            <numerusform>%Ln seeds</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::ProblemPanel</name>
    <message numerus="yes">
        <source>%L1 of %Ln problem(s) selected</source>
        <translation>
            <numerusform>%L1 of %Ln problem selected</numerusform>
            <numerusform>%L1 of %Ln problems selected</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln problem(s)</source>
        <translation>
            <numerusform>%Ln problem</numerusform>
            <numerusform>%Ln problems</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::SeedTool</name>
    <message numerus="yes">
        <source>Move %n Seed(s)</source>
        <translation>
            <numerusform>Move Seed</numerusform>
            <numerusform>Move %n Seeds</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln seed(s) selected · Drag or arrow keys: move · Del: delete · Ctrl+click: add · Esc: deselect</source>
        <translation>
            <numerusform>%Ln seed selected · Drag or arrow keys: move · Del: delete · Ctrl+click: add · Esc: deselect</numerusform>
            <numerusform>%Ln seeds selected · Drag or arrow keys: move · Del: delete · Ctrl+click: add · Esc: deselect</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln fragment(s) selected · Ctrl+click: add · Esc: deselect</source>
        <translation>
            <numerusform>%Ln fragment selected · Ctrl+click: add · Esc: deselect</numerusform>
            <numerusform>%Ln fragments selected · Ctrl+click: add · Esc: deselect</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln fragment(s) selected · Drag a seed: move · Del: delete seeds · Ctrl+click: add · Esc: deselect</source>
        <translation>
            <numerusform>%Ln fragment selected · Drag a seed: move · Del: delete seeds · Ctrl+click: add · Esc: deselect</numerusform>
            <numerusform>%Ln fragments selected · Drag a seed: move · Del: delete seeds · Ctrl+click: add · Esc: deselect</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::SelectActions</name>
    <message numerus="yes">
        <source>Level &amp;%1: %n fragment(s)</source>
        <translation>
            <numerusform>Level &amp;%1: %n fragment</numerusform>
            <numerusform>Level &amp;%1: %n fragments</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::StrengthPanel</name>
    <message numerus="yes">
        <source>%Ln fragment(s), touching pairs: %L1, deepest overlap: %2</source>
        <translation>
            <numerusform>%Ln fragment, touching pairs: %L1, deepest overlap: %2</numerusform>
            <numerusform>%Ln fragments, touching pairs: %L1, deepest overlap: %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::TimelineBar</name>
    <message numerus="yes">
        <source>%Ln earlier timeline(s) from here</source>
        <translation>
            <numerusform>%Ln earlier timeline from here</numerusform>
            <numerusform>%Ln earlier timelines from here</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %Ln other event(s)</source>
        <translation>
            <numerusform>and %Ln other event</numerusform>
            <numerusform>and %Ln other events</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::VideoActions</name>
    <message numerus="yes">
        <source>Exported %n frame(s) to %1.</source>
        <translation>
            <numerusform>Exported %n frame to %1.</numerusform>
            <numerusform>Exported %n frames to %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::VideoDialog</name>
    <message numerus="yes">
        <source>%Ln frame(s) of %1 × %2 pixels: %3 of video from %4 of simulation.</source>
        <translation>
            <numerusform>%Ln frame of %1 × %2 pixels: %3 of video from %4 of simulation.</numerusform>
            <numerusform>%Ln frames of %1 × %2 pixels: %3 of video from %4 of simulation.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::VolumeHistogram</name>
    <message numerus="yes">
        <source>%Ln fragment(s) from %1 to %2</source>
        <translation>
            <numerusform>%Ln fragment from %1 to %2</numerusform>
            <numerusform>%Ln fragments from %1 to %2</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 to %2: %Ln fragment(s)</source>
        <translation>
            <numerusform>%1 to %2: %Ln fragment</numerusform>
            <numerusform>%1 to %2: %Ln fragments</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>rubble::VolumeRangeDialog</name>
    <message numerus="yes">
        <source>%L1 of %Ln fragment(s)</source>
        <translation>
            <numerusform>%L1 of %Ln fragment</numerusform>
            <numerusform>%L1 of %Ln fragments</numerusform>
        </translation>
    </message>
</context>
</TS>
