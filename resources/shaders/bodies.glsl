// Finds the body of a vertex: where it stands, what it looks like. See RenderScene.
uniform samplerBuffer motions;  // three texels a body: position and shrinking, orientation (x, y, z, w), way apart
uniform usamplerBuffer looks;   // one: outside and inside colour (0xRRGGBB), marks

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
vec4 orientationOfBody() { return texelFetch(motions, 3 * bodyIndex() + 1); }
vec3 pointInScene() {
    int first = 3 * bodyIndex();
    vec4 place = texelFetch(motions, first);
    return place.xyz + edges.z * texelFetch(motions, first + 2).xyz +
           turned(orientationOfBody(), (1.0 - place.w) * position);
}
// Where nothing is drawn.
const vec4 kNowhere = vec4(2.0, 2.0, 2.0, 1.0);
