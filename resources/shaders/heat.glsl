// The colour of how near a place of a surface comes to breaking its body: BodyForecast::at(), here for every pixel.
uniform samplerBuffer heats;  // five texels a row: SurfaceHeat

float heatAt(uint row, vec3 point, vec3 normal) {
    int first = 5 * int(row - 1u);
    vec4 centre = texelFetch(heats, first), velocity = texelFetch(heats, first + 1), spin = texelFetch(heats, first + 2);
    vec4 inertia = texelFetch(heats, first + 3), products = texelFetch(heats, first + 4);
    vec3 way = point - missile.xyz, arm = point - centre.xyz;
    float squared = missileWay.w + 2.0 * dot(missileWay.xyz, way);
    float distance = length(way);
    if (squared <= 0.0 || distance == 0.0) return 0.0;
    float speed = sqrt(squared);
    float approach = dot(velocity.xyz + cross(spin.xyz, arm) - way * (speed / distance), normal);
    if (approach <= strike.x) return 0.0;
    if (products.w >= 0.0) return max(products.w, speed / missile.w) * velocity.w;
    vec3 turn = cross(arm, normal);
    vec3 answer = inertia.xyz * turn + vec3(dot(products.xy, turn.yz), dot(products.xz, turn.xz), dot(products.yz, turn.xy));
    float thrownBack = approach > strike.y ? spin.w : 1.0;
    return thrownBack * approach / (missile.w + centre.w + dot(turn, answer)) * velocity.w;
}

vec3 heatColour(float value) {
    if (value >= 1.0) return heatRamp[5].rgb;
    float place = 4.0 * max(value, 0.0);
    int below = min(int(place), 3);
    return mix(heatRamp[below].rgb, heatRamp[below + 1].rgb, place - float(below));
}

vec3 surfaceColour(vec3 colour, uint row, vec3 point, vec3 normal) {
    return row == 0u ? colour : heatColour(heatAt(row, point, normal));
}
