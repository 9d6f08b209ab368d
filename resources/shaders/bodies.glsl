// Finds the body of a vertex: where it stands, what it looks like. See RenderScene.
uniform samplerBuffer motions;  // two texels a body: position and shrinking, orientation (x, y, z, w)
uniform samplerBuffer earlier;  // the same, a step before; read only where edges.w < 1
uniform samplerBuffer apart;    // one: the way apart; read only where edges.z > 0
uniform usamplerBuffer looks;   // one: outside and inside colour (0xRRGGBB), marks, row of heat

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in uint piece;
layout(location = 4) in vec2 across;
layout(location = 5) in uint side;  // 0 outside, 1 inside
layout(location = 6) in uint firstBody;

const uint kHidden = 1u;
const uint kSelected = 2u;
const uint kHovered = 4u;

int bodyIndex() { return int(firstBody + piece); }
uvec4 lookOfBody() {
    uvec4 look = texelFetch(looks, bodyIndex());
    if (uint(bodyIndex()) + 1u == hovered.x) look.z |= kHovered;
    return look;
}

vec3 turned(vec4 orientation, vec3 v) {
    return v + 2.0 * cross(orientation.xyz, cross(orientation.xyz, v) + orientation.w * v);
}
struct BodyPose {
    vec4 place;  // w: how much it has shrunk
    vec4 orientation;
};
// Between the poses a step before and now; turned the shorter way.
BodyPose poseOfBody() {
    int first = 2 * bodyIndex();
    BodyPose now = BodyPose(texelFetch(motions, first), texelFetch(motions, first + 1));
    if (edges.w >= 1.0) return now;
    vec4 turn = texelFetch(earlier, first + 1);
    if (dot(turn, now.orientation) < 0.0) turn = -turn;
    return BodyPose(mix(texelFetch(earlier, first), now.place, edges.w),
                    normalize(mix(turn, now.orientation, edges.w)));
}
vec3 pointInScene(BodyPose pose) {
    vec3 point = pose.place.xyz + turned(pose.orientation, (1.0 - pose.place.w) * position);
    return edges.z > 0.0 ? point + edges.z * texelFetch(apart, bodyIndex()).xyz : point;
}
// Where nothing is drawn.
const vec4 kNowhere = vec4(2.0, 2.0, 2.0, 1.0);
