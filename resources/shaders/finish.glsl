// What a surface is made of: core/asset/finish has the same formula for nearby points, which describes the parameters.
#ifdef FINISHED
uniform sampler3D finishNoise;
const int kFinishSize = 13;
layout(std140) uniform Finishes {
    vec4 finishes[3 * 13];  // of the outside, of the inside, of mortar
    vec4 wholeSize;         // m: of the asset's box
};
in vec3 restPoint;  // in the asset's frame, in which nothing moves when it breaks
in vec3 restNormal;
flat in int finishSide;
flat in int courseUp;

const float kLapShade = 0.75;  // of the light that is lost beside the edge of a course
const float kLapRun = 0.85;    // the part of a course from its top to its highest place

// 1 as long as what repeats so often from pixel to pixel can be seen, 0 where it would only flicker.
float resolved(float repetitions) { return 1.0 - smoothstep(0.25, 0.6, repetitions); }

// The normal of a surface with heights over it, m.
// Source: Mikkelsen, "Bump mapping unparametrized surfaces on the GPU", 2010.
vec3 raised(vec3 n, float height) {
    vec3 alongX = dFdx(scenePoint), alongY = dFdy(scenePoint);
    vec3 right = cross(alongY, n), up = cross(n, alongX);
    float area = dot(alongX, right);
    vec3 slope = sign(area) * (dFdx(height) * right + dFdy(height) * up);
    return normalize(abs(area) * n - slope);
}

// Along courses and up, m: in the plane of two axes that the face is nearest to.
vec2 courseCoordinates() {
    vec3 size = abs(restNormal);
    int across = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0, rising = abs(courseUp) - 1;
    if (across == rising) return vec2(restPoint[(rising + 2) % 3], restPoint[(rising + 1) % 3]);
    return vec2(restPoint[3 - across - rising], sign(float(courseUp)) * restPoint[rising]);
}

// With an axis as the first.
vec3 along(vec3 v, float axis) { return axis < 0.5 ? v : axis < 1.5 ? v.yzx : v.zxy; }

Surface finished(Surface plain) {
    int first = kFinishSize * finishSide;
    vec4 scales = finishes[first], tones = finishes[first + 1], stain = finishes[first + 2], speckColour = finishes[first + 3];
    vec4 specks = finishes[first + 4], heights = finishes[first + 5], bandCentre = finishes[first + 6];
    vec4 bandAxes = finishes[first + 7], courses = finishes[first + 8], joint = finishes[first + 9];
    vec2 lap = finishes[first + 10].xy;
    vec4 pairs = finishes[first + 11];
    vec4 origin = finishes[first + 12];  // x, y: of the courses; w: the axis of the grain
    vec3 p = along(restPoint, origin.w);
    vec3 stretched = p * vec3(scales.z, 1.0, 1.0);
    vec4 broad = texture(finishNoise, scales.x * stretched), fine = texture(finishNoise, scales.y * stretched);

    float bands = (length((p - bandCentre.xyz) * bandAxes.xyz) + scales.w * (broad.x - 0.5)) * bandCentre.w;
    float t = fract(bands), shownBands = resolved(fwidth(bands));
    float band = mix(0.35, t * (1.0 - smoothstep(0.7, 1.0, t)), bandCentre.w > 0.0 ? shownBands : 0.0);
    float speck = 1.0 - smoothstep(specks.x - specks.y, specks.x + specks.y, fine.z);
    float tone = 1.0 + tones.x * (2.0 * broad.x - 1.0) + tones.y * (2.0 * fine.y - 1.0) + tones.z * (band - 0.35);
    vec3 albedo = plain.albedo * tone * mix(vec3(1.0), stain.rgb, stain.a * smoothstep(0.5, 0.8, broad.y));
    albedo = mix(albedo, plain.albedo * speckColour.rgb * (0.7 + 0.6 * fine.w), speckColour.a * speck);
    float height = dot(heights.xyz, vec3(broad.x, fine.x, band)) + specks.z * speck;
    float roughness = specks.w + heights.w * (2.0 * fine.y - 1.0), metalness = bandAxes.w;

    vec2 place = courseCoordinates() - origin.xy;
    // In a course, bricks of two lengths alternate; odd courses have others, and start elsewhere.
    float rows = place.y / courses.y, row = floor(rows);
    bool isOdd = row - 2.0 * floor(0.5 * row) > 0.5;
    vec2 lengths = isOdd ? pairs.yz : vec2(courses.x, pairs.x);
    float from = place.x - (isOdd ? pairs.w : 0.0), pair = floor(from / (lengths.x + lengths.y));
    float rest = from - pair * (lengths.x + lengths.y), isSecond = step(lengths.x, rest);
    vec2 size = vec2(mix(lengths.x, lengths.y, isSecond), courses.y);
    vec2 cell = vec2((rest - isSecond * lengths.x) / size.x, rows - row), apart = min(cell, 1.0 - cell) * size;
    float column = 2.0 * pair + isSecond;
    vec2 perPixel = fwidth(place);
    float pixel = max(perPixel.x, perPixel.y);
    float shownBricks = resolved(pixel / courses.y);
    float reach = max(lap.y, pixel), shaded = 1.0 - smoothstep(0.0, reach, (1.0 - cell.y) * courses.y);
    albedo *= 1.0 - kLapShade * shaded * lap.y / max(reach, 1e-6);
    height += lap.x * shownBricks * min((1.0 - cell.y) / kLapRun, cell.y / (1.0 - kLapRun));
    float edge = (min(apart.x, apart.y) - 0.5 * courses.z) / max(0.3 * courses.z, pixel);
    float inJoint = courses.z > 0.0 ? (1.0 - smoothstep(-0.5, 0.5, edge)) * min(1.0, courses.z / pixel) : 0.0;
    float brick = tones.w * (2.0 * randomAt(ivec2(column, row)) - 1.0) * shownBricks;
    albedo = mix(albedo * (1.0 + brick), joint.rgb * (0.85 + 0.3 * fine.x), inJoint);
    height = mix(height, courses.w, inJoint);
    return Surface(clamp(albedo, 0.0, 1.0), raised(plain.normal, height),
                   clamp(mix(roughness, 0.95, inJoint), 0.03, 1.0), metalness * (1.0 - inJoint), plain.occlusion);
}

const float kRefractiveIndex = 1.5;
const float kLongestWay = 6.0;  // times the thickness

// How far light goes through the asset to a point of its surface, times its thickness; at least 1. `facingEye`: the
// cosine of the angle between the normal and the direction to the eye.
float wayThrough(float facingEye) {
    vec3 n = abs(restNormal), size = max(wholeSize.xyz, 1e-6);
    float thickness = min(size.x, min(size.y, size.z));
    vec3 across = n.x >= n.y && n.x >= n.z ? size.yzz : n.y >= n.z ? size.xzz : size.xyy;
    float sine = sqrt(max(1.0 - facingEye * facingEye, 0.0)) / kRefractiveIndex, cosine = sqrt(1.0 - sine * sine);
    float way = min(dot(n, size) / cosine, min(across.x, across.y) / max(sine, 1e-3));
    return clamp(way / thickness, 1.0, kLongestWay);
}

const float kEdgeShade = 0.5;      // brightness of edges, of that of the surface
const float kBevelWidth = 0.006;   // m
const float kMaxBevelPixels = 5.0;
const float kBevelSlope = 0.8;

// A surface with worn edges: its normal leans outwards there.
Surface bevelled(Surface surface) {
    float width = min(kBevelWidth * pixelsPerMetre(max(dot(eye.xyz - scenePoint, back.xyz), 1e-6)), kMaxBevelPixels);
    float slope = clamp(1.0 - pixelsToEdge(placeAcross) / max(width, 0.5), 0.0, 1.0) * min(width, 1.0);
    mat2x3 along = mat2x3(dFdx(scenePoint), dFdy(scenePoint));
    surface.normal = normalize(surface.normal + kBevelSlope * slope * towardsEdge(placeAcross, along));
    return surface;
}
#else
const float kEdgeShade = 0.22;
Surface finished(Surface plain) { return plain; }
Surface bevelled(Surface surface) { return surface; }
float wayThrough(float facingEye) { return 1.0; }
#endif
