layout(location = 7) in float sizeCode;  // see SceneVertex
out vec3 scenePoint;
out vec3 sceneNormal;
out vec2 placeAcross;
out float edgeWidth;  // pixels, on each side of an edge
flat out vec3 colour;  // linear
flat out float opacity;
#ifdef FINISHED
uniform samplerBuffer restOffsets;  // one texel per body: the origin of its frame in the asset's, m; w: courseUp
out vec3 restPoint;
out vec3 restNormal;
flat out int finishSide;
flat out int courseUp;  // 1, 2, 3: courses rise along x, y, z of the asset; negative: against it
#endif
#ifdef TEXTURED
out vec2 placeInImage;  // from its top left corner
flat out float hasImage;  // 1 on textured faces
#endif

const float kEdgeWidth = 0.0065;  // of the size of its fragment
const float kThinnest = 0.12, kWidest = 0.75;  // points

const vec3 kMortarColour = vec3(0.76, 0.74, 0.70);  // sRGB

vec3 unpackedColour(uint rgb) { return vec3((rgb >> 16) & 255u, (rgb >> 8) & 255u, rgb & 255u) / 255.0; }

void main() {
    uvec4 appearance = appearanceOfBody();
    BodyPose pose = poseOfBody();
    scenePoint = pointInScene(pose);
    sceneNormal = rotated(pose.orientation, normal);
    placeAcross = across;
    float size = exp2((sizeCode - 128.0) / 8.0) * pixelsPerMetre(max(dot(eye.xyz - scenePoint, back.xyz), 1e-6));
    edgeWidth = clamp(kEdgeWidth * size, kThinnest * edges.x, kWidest * edges.x);
    colour = linearOf(side == kMortar ? kMortarColour : unpackedColour(side == kInside ? appearance.y : appearance.x));
    opacity = opacityOf(appearance);
#ifdef FINISHED
    vec4 rest = texelFetch(restOffsets, bodyIndex());
    restPoint = position + rest.xyz;
    courseUp = int(rest.w);
    restNormal = normal;
    finishSide = side == kMortar ? 2 : side == kInside ? 1 : 0;
#endif
#ifdef TEXTURED
    placeInImage = vec2(uv.x, 1.0 - uv.y);
    hasImage = side == kTextured ? 1.0 : 0.0;
#endif
    gl_Position = isShown(appearance) ? clipFromScene * vec4(scenePoint, 1.0) : kClipped;
}
