// Accumulates transparent surfaces in any order: nearer ones weigh more.
// Source: McGuire, Bavoil, "Weighted Blended Order-Independent Transparency", 2013.
uniform float focusDistance;  // of the camera's target, m
layout(location = 0) out vec4 sum;     // colours times weights; a: the product of transparencies, by its blend function
layout(location = 1) out vec4 weights;  // and displacements of what is behind, pixels, times weights

const float kGlossiness = 0.05;   // roughness
const float kNearness = 5.0;      // halvings of the weight over the target's distance
const float kEdgeOpacity = 0.55;
const float kNarrowest = 0.5, kWholeWidth = 2.0;  // pixels: narrower faces, as the sides of panes, would be speckles
const float kLeastFraction = 0.25;                // of their opacity
const float kDisplacement = 0.03;    // m, of what is seen through a surface at a grazing angle
const float kMaxDisplacement = 24.0; // pixels

// Edges of what has a finish are worn, and bright.
#ifdef FINISHED
vec3 edgeColour(vec3 shaded, vec3 mirrored) { return shaded + 0.6 * mirrored; }
#else
vec3 edgeColour(vec3 shaded, vec3 mirrored) { return shaded * kEdgeShade; }
#endif

void main() {
    Surface surface = surfaceHere();
    vec3 shaded = shadedSurface(surface), toEye = towardsEye(), n = surface.normal;
    float facingEye = clamp(dot(n, toEye), 0.0, 1.0);
    float mirror = kReflectance + (1.0 - kReflectance) * pow(1.0 - facingEye, 5.0);
    float line = edgeCover();
    float seenWidth = smoothstep(kNarrowest, kWholeWidth, pixelsAcross(placeAcross));
    float wide = mix(kLeastFraction, 1.0, seenWidth), way = mix(1.0, wayThrough(facingEye), seenWidth);
    float absorbed = 1.0 - pow(1.0 - opacity, way);  // Lambert's law
    float alpha = wide * max(absorbed + (1.0 - absorbed) * mirror, kEdgeOpacity * line);
    vec3 mirrored = reflected(reflect(-toEye, n), kGlossiness);
    vec3 seen = displayed(mix(mix(shaded, mirrored, mirror), edgeColour(shaded, mirrored), line));
    float far = dot(eye.xyz - scenePoint, back.xyz) / focusDistance;
    float weight = alpha * clamp(exp2(-kNearness * (far - 1.0)), 1e-3, 1e3);
    sum = vec4(seen * weight, alpha);
    float pixels = min(kDisplacement * pixelsPerMetre(dot(eye.xyz - scenePoint, back.xyz)), kMaxDisplacement);
    weights = vec4(weight, -pixels * weight * vec2(dot(n, right.xyz), dot(n, up.xyz)), 0.0);
}
