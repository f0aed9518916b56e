// An endless checkered floor. Every pixel finds its point by itself, so that the floor reaches the
// horizon and its tiles do not depend on how a huge quad is cut up and rounded.
in vec3 ray;

uniform vec3 eye;
uniform vec3 light;
uniform float height;
uniform float tile;
uniform float near;
uniform float far;

out vec4 fragment_color;

// The share of white in a pixel: the mean of the pattern over the pixel's footprint, so that tiles
// smaller than a pixel are gray instead of noise.
float white(vec2 at, vec2 footprint) {
    vec2 width = max(footprint, vec2(1e-4));
    vec2 mean = 2.0 * (abs(fract((at - 0.5 * width) * 0.5) - 0.5)
        - abs(fract((at + 0.5 * width) * 0.5) - 0.5)) / width;
    return 0.5 - 0.5 * mean.x * mean.y;
}

void main() {
    // The derivatives need a point beside the horizon, too.
    float steepness = height < eye.y ? min(ray.y, -1e-6) : max(ray.y, 1e-6);
    float along = (height - eye.y) / steepness;
    vec3 at = eye + along * ray;
    vec2 cell = at.xz / tile;
    vec2 footprint = abs(dFdx(cell)) + abs(dFdy(cell));
    if (steepness != ray.y || along < near) {
        discard;
    }
    vec3 l = light - at;
    float diffuse = max(l.y, 0.0) * inversesqrt(dot(l, l));
    fragment_color = vec4(vec3(white(cell, footprint) * diffuse), 1.0);
    // What lies beyond the far plane is still behind everything.
    float depth = (far + near - 2.0 * far * near / along) / (far - near);
    gl_FragDepth = clamp(0.5 * depth + 0.5, 0.0, 0.9999999);
}
