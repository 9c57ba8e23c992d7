#include "crt/glass_shaders.h"

#include <stddef.h>

/* One triangle that covers the framebuffer, without any buffer. */
const char *const crt_glass_vertex[] = {
    "void main()\n"
    "{\n"
    "    vec2 p = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);\n"
    "    gl_Position = vec4(p * 2.0 - 1.0, 0.0, 1.0);\n"
    "}\n",
    NULL};

/* The film as one float, two or three, so that a tube of one colour pays for one. */
#define LIGHT                                                                                      \
    "#if COLOURS == 3\n"                                                                           \
    "#define light vec3\n"                                                                         \
    "#define READ(s) (s).rgb\n"                                                                    \
    "uniform sampler2D film0;\n"                                                                   \
    "vec3 film(ivec2 t)\n"                                                                         \
    "{\n"                                                                                          \
    "    return texelFetch(film0, t, 0).rgb;\n"                                                    \
    "}\n"                                                                                          \
    "#elif COLOURS == 2\n"                                                                         \
    "#define light vec2\n"                                                                         \
    "#define READ(s) (s).rg\n"                                                                     \
    "uniform sampler2D film0, film1;\n"                                                            \
    "vec2 film(ivec2 t)\n"                                                                         \
    "{\n"                                                                                          \
    "    return vec2(texelFetch(film0, t, 0).r, texelFetch(film1, t, 0).r);\n"                     \
    "}\n"                                                                                          \
    "#else\n"                                                                                      \
    "#define light float\n"                                                                        \
    "#define READ(s) (s).r\n"                                                                      \
    "uniform sampler2D film0;\n"                                                                   \
    "float film(ivec2 t)\n"                                                                        \
    "{\n"                                                                                          \
    "    return texelFetch(film0, t, 0).r;\n"                                                      \
    "}\n"                                                                                          \
    "#endif\n"

/* From window pixels to film cells, counted from the centre. */
#define WARP                                                                                       \
    "uniform ivec2 size;             /* of the film, cells */\n"                                   \
    "uniform vec2 middle;            /* window pixel of the screen's centre */\n"                  \
    "uniform float cells_per_pixel;\n"                                                             \
    "uniform float bend;             /* (1 cell / face radius) squared */\n"                       \
    "vec2 seen_at(vec2 p)\n"                                                                       \
    "{\n"                                                                                          \
    "    return (p - middle) * cells_per_pixel;\n"                                                 \
    "}\n"                                                                                          \
    "vec2 stretched(vec2 c)\n"                                                                     \
    "{\n"                                                                                          \
    "#if CURVED\n"                                                                                 \
    "    float u = min(dot(c, c) * bend, BEND_MAX);\n"                                             \
    "    c *= 1.0 + u * (1.0 / 6.0 + u * (3.0 / 40.0 + u * (15.0 / 336.0)));\n"                    \
    "#endif\n"                                                                                     \
    "    return c;\n"                                                                              \
    "}\n"

/* One direction of a separable blur; beyond the edge is dark. */
const char *const crt_glass_blur[] = {
    "uniform sampler2D source;\n"
    "uniform ivec2 size;\n"
    "uniform ivec2 along;\n"
    "uniform int radius;\n"
    "uniform float weight[RADIUS_MAX + 1];\n"
    "out vec4 blurred;\n"
    "void main()\n"
    "{\n"
    "    ivec2 here = ivec2(gl_FragCoord.xy);\n"
    "    int at = along.x == 1 ? here.x : here.y;\n"
    "    int last = (along.x == 1 ? size.x : size.y) - 1;\n"
    "    vec4 sum = vec4(0.0);\n"
    "    for (int k = max(-radius, -at); k <= min(radius, last - at); k++)\n"
    "        sum += weight[abs(k)] * texelFetch(source, here + along * k, 0);\n"
    "    blurred = sum;\n"
    "}\n",
    NULL};

/* Keys' cubic with a = -0.65: of the cubics of four taps about the one that follows a spot of
 * sigma = 1 cell best along one axis (error 2.7 % of its peak; Catmull-Rom's a = -0.5 gives 4.8 %,
 * linear 12 %).
 */
#define CUBIC                                                                                      \
    "light sample_film(vec2 t)\n"                                                                  \
    "{\n"                                                                                          \
    "    const float a = -0.65;\n"                                                                 \
    "    vec2 q = floor(t - 0.5);\n"                                                               \
    "    vec2 f = t - 0.5 - q;\n"                                                                  \
    "    vec2 g = 1.0 - f;\n"                                                                      \
    "    vec2 w0 = a * f * g * g;\n"                                                               \
    "    vec2 w3 = a * g * f * f;\n"                                                               \
    "    vec2 w1 = ((a + 2.0) * f - (a + 3.0)) * f * f + 1.0;\n"                                   \
    "    vec2 w2 = 1.0 - w0 - w1 - w3;\n"                                                          \
    "    ivec2 last = size - 1;\n"                                                                 \
    "    ivec2 t1 = ivec2(q);\n"                                                                   \
    "    ivec2 t0 = clamp(t1 - 1, ivec2(0), last);\n"                                              \
    "    ivec2 t2 = clamp(t1 + 1, ivec2(0), last);\n"                                              \
    "    ivec2 t3 = clamp(t1 + 2, ivec2(0), last);\n"                                              \
    "    t1 = clamp(t1, ivec2(0), last);\n"                                                        \
    "#define ROW(y)                                                           \\\n"                \
    "    (w0.x * film(ivec2(t0.x, y)) + w1.x * film(ivec2(t1.x, y)) +         \\\n"                \
    "     w2.x * film(ivec2(t2.x, y)) + w3.x * film(ivec2(t3.x, y)))\n"                            \
    "    light sum = w0.y * ROW(t0.y) + w1.y * ROW(t1.y) + w2.y * ROW(t2.y) + w3.y * ROW(t3.y);\n" \
    "    return max(sum, light(0.0));\n"                                                           \
    "}\n"

/* The exact mean of the film, as squares of even light, over a square of `cells_per_pixel`; AREA3
 * knows that it touches at most three cells each way. */
#define AREA                                                                                       \
    "vec2 overlap(vec2 low, vec2 high, ivec2 t)\n"                                                 \
    "{\n"                                                                                          \
    "    return max(min(high, vec2(t + 1)) - max(low, vec2(t)), 0.0);\n"                           \
    "}\n"                                                                                          \
    "light sample_film(vec2 t)\n"                                                                  \
    "{\n"                                                                                          \
    "    vec2 low = clamp(t - 0.5 * cells_per_pixel, vec2(0.0), vec2(size));\n"                    \
    "    vec2 high = clamp(t + 0.5 * cells_per_pixel, vec2(0.0), vec2(size));\n"                   \
    "    ivec2 from = min(ivec2(low), size - 1);\n"                                                \
    "    light sum = light(0.0);\n"                                                                \
    "#if SAMPLE == SAMPLE_AREA3\n"                                                                 \
    "    ivec2 mid = min(from + 1, size - 1), to = min(from + 2, size - 1);\n"                     \
    "    vec2 a = overlap(low, high, from);\n"                                                     \
    "    vec2 b = overlap(low, high, from + 1);\n"                                                 \
    "    vec2 c = overlap(low, high, from + 2);\n"                                                 \
    "#define ROW(y)                                                                   \\\n"        \
    "    (a.x * film(ivec2(from.x, y)) + b.x * film(ivec2(mid.x, y)) + c.x * film(ivec2(to.x, "    \
    "y)))\n"                                                                                       \
    "    sum = a.y * ROW(from.y) + b.y * ROW(mid.y) + c.y * ROW(to.y);\n"                          \
    "#else\n"                                                                                      \
    "    ivec2 to = min(ivec2(ceil(high)), size);\n"                                               \
    "    for (int y = from.y; y < to.y; y++) {\n"                                                  \
    "        light row = light(0.0);\n"                                                            \
    "        for (int x = from.x; x < to.x; x++)\n"                                                \
    "            row += overlap(low, high, ivec2(x, y)).x * film(ivec2(x, y));\n"                  \
    "        sum += overlap(low, high, ivec2(from.x, y)).y * row;\n"                               \
    "    }\n"                                                                                      \
    "#endif\n"                                                                                     \
    "    return sum / (cells_per_pixel * cells_per_pixel);\n"                                      \
    "}\n"

/* Light, then what the eye is shown: tone (crt_tone_at), gamut (crt_fit_srgb), sRGB. */
#define DISPLAY                                                                                    \
    "uniform sampler2D curve;\n"                                                                   \
    "uniform float halation;\n"                                                                    \
    "uniform float scale;            /* film to relative luminance */\n"                           \
    "uniform float room;             /* relative luminance */\n"                                   \
    "uniform vec3 unit0, unit1, unit2; /* linear sRGB of luminance 1 in each colour */\n"          \
    "float tone(float v)\n"                                                                        \
    "{\n"                                                                                          \
    "    float t = min(v, TONE_MAX) * TONE_SCALE;\n"                                               \
    "    int i = min(int(sqrt(t)), TONE_SIZE - 2);\n"                                              \
    "    float a = texelFetch(curve, ivec2(i, 0), 0).r;\n"                                         \
    "    float b = texelFetch(curve, ivec2(i + 1, 0), 0).r;\n"                                     \
    "    float shown = a + (b - a) * (t - float(i * i)) / float(2 * i + 1);\n"                     \
    "    return v <= TONE_SHOULDER ? v : shown;\n"                                                 \
    "}\n"                                                                                          \
    "vec3 fit(float y, vec3 unit)\n"                                                               \
    "{\n"                                                                                          \
    "    vec3 e = unit - 1.0;\n"                                                                   \
    "    float low = -min(e.r, min(e.g, e.b)), high = max(e.r, max(e.g, e.b));\n"                  \
    "    float lit = clamp(y, 0.0, 1.0), left = 1.0 - lit;\n"                                      \
    "    float chroma = low > 1.0 ? lit / low : lit;\n"                                            \
    "    float rise = chroma * high;\n"                                                            \
    "    if (rise > 0.0)\n"                                                                        \
    "        chroma *= left / sqrt(left * left + rise * rise);\n"                                  \
    "    return clamp(lit + chroma * e, 0.0, 1.0);\n"                                              \
    "}\n"                                                                                          \
    "vec3 encode(vec3 c)\n"                                                                        \
    "{\n"                                                                                          \
    "    c = clamp(c, 0.0, 1.0);\n"                                                                \
    "    vec3 high = 1.055 * pow(max(c, 0.0031308), vec3(1.0 / 2.4)) - 0.055;\n"                   \
    "    return mix(high, 12.92 * c, lessThanEqual(c, vec3(0.0031308)));\n"                        \
    "}\n"                                                                                          \
    "vec3 show(light l, float glow, float shade)\n"                                                \
    "{\n"                                                                                          \
    "#if COLOURS == 3\n"                                                                           \
    "    float y = (l.x + l.y + l.z) * scale + glow;\n"                                            \
    "    vec3 rgb = (l.x * unit0 + l.y * unit1 + l.z * unit2) * scale + glow;\n"                   \
    "#elif COLOURS == 2\n"                                                                         \
    "    float y = (l.x + l.y) * scale + glow;\n"                                                  \
    "    vec3 rgb = (l.x * unit0 + l.y * unit1) * scale + glow;\n"                                 \
    "#else\n"                                                                                      \
    "    float y = l * scale + glow;\n"                                                            \
    "    vec3 rgb = l * scale * unit0 + glow;\n"                                                   \
    "#endif\n"                                                                                     \
    "    return encode(fit(tone(y * shade), rgb / max(y, 1e-30)));\n"                              \
    "}\n"                                                                                          \
    "/* How much room light the face sends back. */\n"                                             \
    "float glint(vec2 c)\n"                                                                        \
    "{\n"                                                                                          \
    "#if ROOM && CURVED\n"                                                                         \
    "    /* A lamp up on the left, mirrored weakly and widely. */\n"                               \
    "    vec2 lamp = c / (0.5 * float(size.y)) - vec2(-0.45, -0.55);\n"                            \
    "    float n = max(1.0 - 1.6 * dot(lamp, lamp), 0.0);\n"                                       \
    "    return room * (1.0 + 0.5 * n * n);\n"                                                     \
    "#else\n"                                                                                      \
    "    return room;\n"                                                                           \
    "#endif\n"                                                                                     \
    "}\n"

/* Corners of the face's squares, pixels from the tile's top left. Scattered light varies so slowly
 * that it is read here; where there is only that and room light, the colour is found here too. */
const char *const crt_glass_place_vertex[] = {
    LIGHT, WARP, DISPLAY,
    "layout(location = 0) in vec2 place;\n"
    "uniform ivec4 tile; /* x, y in the window; width, height */\n"
    "uniform sampler2D halo;\n"
    "uniform vec2 halo_cells; /* cells that the halo texture spans */\n"
    "#if SAMPLE == SAMPLE_SMOOTH\n"
    "out vec3 colour;\n"
    "#else\n"
    "out light scattered;\n"
    "#endif\n"
    "void main()\n"
    "{\n"
    "    vec2 at = 2.0 * place / vec2(tile.zw) - 1.0;\n"
    "    gl_Position = vec4(at.x, -at.y, 0.0, 1.0);\n"
    "    vec2 c = seen_at(vec2(tile.xy) + place);\n"
    "    light l = light(0.0);\n"
    "#if HALO\n"
    "    vec2 t = stretched(c) + 0.5 * vec2(size);\n"
    "    l = READ(textureLod(halo, t / halo_cells, 0.0));\n"
    "#endif\n"
    "#if SAMPLE == SAMPLE_SMOOTH\n"
    "    colour = show(l * halation, glint(c), 1.0);\n"
    "#else\n"
    "    scattered = l;\n"
    "#endif\n"
    "}\n",
    NULL};

/* Room and scattered light vary by less than a step of 8 bits over many pixels, which would show as
 * rings: an ordered dither (Bayer's 8 × 8 matrix) within half a step either way, so that black stays
 * black, and the same picture gives the same samples however it is cut into tiles. */
#define DITHER                                                                                     \
    "uniform float grain;            /* a step of the framebuffer */\n"                            \
    "vec3 dithered(vec3 c)\n"                                                                      \
    "{\n"                                                                                          \
    "#if HALO || ROOM\n"                                                                           \
    "    int x = tile.x + int(gl_FragCoord.x);\n"                                                  \
    "    int y = tile.y + tile.w - 1 - int(gl_FragCoord.y);\n"                                     \
    "    int q = x ^ y;\n"                                                                         \
    "    int rank = (q & 1) << 5 | (y & 1) << 4 | (q & 2) << 2 | (y & 2) << 1 |\n"                 \
    "               (q & 4) >> 1 | (y & 4) >> 2;\n"                                                \
    "    c += grain * (float(rank) - 31.5) / 65.0;\n"                                              \
    "#endif\n"                                                                                     \
    "    return c;\n"                                                                              \
    "}\n"

/* What the mask lets of each colour be seen, 1 on average: a table of one period, and the shadows of
 * damper wires. */
#define PATTERN                                                                                    \
    "#if MASK\n"                                                                                   \
    "uniform sampler2D pattern;\n"                                                                 \
    "uniform vec2 mask_period;       /* cells */\n"                                                \
    "uniform vec2 mask_from;         /* the film's centre, cells from the tube's */\n"             \
    "uniform float mask_depth;       /* 0: even light */\n"                                        \
    "uniform vec2 wire;              /* distance from the middle, half width, cells */\n"          \
    "vec3 seen_through(vec2 c)\n"                                                                  \
    "{\n"                                                                                          \
    "    vec2 at = c + mask_from;\n"                                                               \
    "    vec3 share = textureLod(pattern, at / mask_period, 0.0).rgb;\n"                           \
    "    float off = abs(abs(at.y) - wire.x), half_pixel = 0.5 * cells_per_pixel;\n"               \
    "    float dark = min(off + half_pixel, wire.y) - max(off - half_pixel, -wire.y);\n"           \
    "    share *= 1.0 - max(dark, 0.0) / cells_per_pixel;\n"                                       \
    "    return mix(vec3(1.0), share, mask_depth);\n"                                              \
    "}\n"                                                                                          \
    "#endif\n"

const char *const crt_glass_face[] = {
    LIGHT,
    WARP,
    "uniform ivec4 tile;             /* x, y in the window; width, height */\n"
    "uniform vec2 edge;              /* corner radius and width of the soft edge, cells */\n"
    "#if SAMPLE == SAMPLE_SMOOTH\n"
    "in vec3 colour;\n"
    "#else\n"
    "in light scattered;\n"
    "#endif\n"
    "out vec4 picture;\n"
    "#if SAMPLE == SAMPLE_CUBIC\n",
    CUBIC,
    "#elif SAMPLE >= SAMPLE_AREA3\n",
    AREA,
    "#elif SAMPLE == SAMPLE_EXACT\n"
    "light sample_film(vec2 t)\n"
    "{\n"
    "    return film(clamp(ivec2(t), ivec2(0), size - 1));\n"
    "}\n"
    "#else\n"
    "light sample_film(vec2 t)\n"
    "{\n"
    "    return light(0.0);\n"
    "}\n"
    "#endif\n",
    DISPLAY,
    DITHER,
    PATTERN,
    "void main()\n"
    "{\n"
    "#if SAMPLE == SAMPLE_SMOOTH\n"
    "    picture = vec4(dithered(colour), 1.0);\n"
    "#else\n"
    "    vec2 here = vec2(gl_FragCoord.x, float(tile.w) - gl_FragCoord.y);\n"
    "    vec2 c = seen_at(vec2(tile.xy) + here);\n"
    "    float glow = glint(c);\n"
    "    c = stretched(c);\n"
    "#if CURVED\n"
    "    vec2 past = abs(c) - 0.5 * vec2(size) + edge.x;\n"
    "    float inside = edge.x - length(max(past, 0.0)) - min(max(past.x, past.y), 0.0);\n"
    "    float shade = smoothstep(0.0, edge.y, inside);\n"
    "#else\n"
    "    vec2 inside = clamp((0.5 * vec2(size) - abs(c)) / cells_per_pixel + 0.5, 0.0, 1.0);\n"
    "    float shade = inside.x * inside.y;\n"
    "#endif\n"
    "    vec2 t = c + 0.5 * vec2(size);\n"
    "    light l = sample_film(t);\n"
    "#if MASK\n"
    "    l *= seen_through(c);\n"
    "#endif\n"
    "#if HALO\n"
    "    l = mix(l, scattered, halation);\n"
    "#endif\n"
    "    picture = vec4(dithered(show(l, glow, shade)), 1.0);\n"
    "#endif\n"
    "}\n",
    NULL};

/* Straight-alpha pixels laid over the picture, one for one. */
const char *const crt_glass_text[] = {
    "uniform sampler2D overlay;\n"
    "uniform ivec2 corner; /* overlay pixel of this framebuffer's bottom left corner */\n"
    "uniform ivec2 size;\n"
    "out vec4 text;\n"
    "void main()\n"
    "{\n"
    "    ivec2 t = ivec2(corner.x + int(gl_FragCoord.x), corner.y - 1 - int(gl_FragCoord.y));\n"
    "    text = texelFetch(overlay, clamp(t, ivec2(0), size - 1), 0);\n"
    "}\n",
    NULL};
