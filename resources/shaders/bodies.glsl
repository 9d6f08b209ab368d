// Looks up the pose and the appearance of a vertex's body: see RenderScene.
uniform samplerBuffer poses;           // two texels per body: position and shrinkage, orientation (x, y, z, w)
uniform samplerBuffer previousPoses;   // the same, one step earlier; read only if edges.w < 1
uniform samplerBuffer explodeOffsets;  // one texel per body; read only if edges.z > 0
uniform usamplerBuffer appearances;    // one texel per body: outside and inside colour (0xTTRRGGBB), marks, outline
uniform uint surfaces;                 // 0: all, 1: opaque ones, 2: transparent ones

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in uint solid;
layout(location = 4) in vec2 across;
layout(location = 5) in uint side;  // see VertexSide
layout(location = 6) in uint firstBody;

invariant gl_Position;  // the same in each pass

const uint kInside = 1u, kTextured = 2u, kMortar = 3u;  // sides

const uint kHidden = 1u;
const uint kSelected = 2u;
const uint kHovered = 4u;

int bodyIndex() { return int(firstBody + solid); }
uvec4 appearanceOfBody() {
    uvec4 appearance = texelFetch(appearances, bodyIndex());
    if (uint(bodyIndex()) + 1u == hovered.x) appearance.z |= kHovered;
    return appearance;
}

vec3 rotated(vec4 orientation, vec3 v) {
    return v + 2.0 * cross(orientation.xyz, cross(orientation.xyz, v) + orientation.w * v);
}
struct BodyPose {
    vec4 position;  // w: shrinkage
    vec4 orientation;
};
// Interpolates the previous and the current pose; rotates the shorter way.
BodyPose poseOfBody() {
    int first = 2 * bodyIndex();
    BodyPose now = BodyPose(texelFetch(poses, first), texelFetch(poses, first + 1));
    if (edges.w >= 1.0) return now;
    vec4 orientation = texelFetch(previousPoses, first + 1);
    if (dot(orientation, now.orientation) < 0.0) orientation = -orientation;
    return BodyPose(mix(texelFetch(previousPoses, first), now.position, edges.w),
                    normalize(mix(orientation, now.orientation, edges.w)));
}
vec3 pointInScene(BodyPose pose) {
    vec3 point = pose.position.xyz + rotated(pose.orientation, (1.0 - pose.position.w) * position);
    return edges.z > 0.0 ? point + edges.z * texelFetch(explodeOffsets, bodyIndex()).xyz : point;
}
float opacityOf(uvec4 appearance) { return 1.0 - float((side == kInside ? appearance.y : appearance.x) >> 24) / 255.0; }
// Whether the body is visible and the surface is one of `surfaces`.
bool isShown(uvec4 appearance) {
    bool isOfKind = surfaces == 0u || (surfaces == 2u) == (opacityOf(appearance) < 1.0);
    return isOfKind && (appearance.z & kHidden) == 0u;
}
// Outside the clip volume: discards the vertex.
const vec4 kClipped = vec4(2.0, 2.0, 2.0, 1.0);
