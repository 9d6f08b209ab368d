// Heat colours: evaluates BodyForecast::at() for every pixel.
uniform samplerBuffer heats;  // five texels a row: SurfaceHeat

float heatAt(uint row, vec3 point, vec3 normal) {
    int first = 5 * int(row - 1u);
    vec4 centre = texelFetch(heats, first), velocity = texelFetch(heats, first + 1);
    vec4 rotation = texelFetch(heats, first + 2);
    vec4 inertia = texelFetch(heats, first + 3), products = texelFetch(heats, first + 4);
    vec3 path = point - projectile.xyz, arm = point - centre.xyz;
    float squared = projectileGravity.w + 2.0 * dot(projectileGravity.xyz, path);
    float distance = length(path);
    if (squared <= 0.0 || distance == 0.0) return 0.0;
    float speed = sqrt(squared);
    float approach = dot(velocity.xyz + cross(rotation.xyz, arm) - path * (speed / distance), normal);
    if (approach <= impactSpeeds.x) return 0.0;
    if (products.w >= 0.0) return max(products.w, speed / projectile.w) * velocity.w;
    vec3 torque = cross(arm, normal);
    vec3 coupling = vec3(dot(products.xy, torque.yz), dot(products.xz, torque.xz), dot(products.yz, torque.xy));
    vec3 response = inertia.xyz * torque + coupling;
    float bounce = approach > impactSpeeds.y ? rotation.w : 1.0;  // 1 + restitution
    return bounce * approach / (projectile.w + centre.w + dot(torque, response)) * velocity.w;
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
