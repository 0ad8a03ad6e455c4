// The two surfaces of a match in one canvas: side by side with one camera, or one over the other. Draws only when something
// has changed.

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DataTexture,
  Group,
  InstancedMesh,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  OrthographicCamera,
  Quaternion,
  Raycaster,
  Scene,
  type ShaderMaterial,
  SphereGeometry,
  Vector2,
  Vector3,
  Vector4,
  WebGLRenderer,
} from "three";
import { TrackballControls } from "three/examples/jsm/controls/TrackballControls.js";
import { STEPS, colorMap, outlierMap, type MapName } from "./colors";
import { type ColumnName, type Pair, placesIn } from "./pair";
import { NO_SECTION, coloredMaterial } from "./shader";

export type Coloring = "correspondence" | ColumnName;
export type Side = "source" | "target";

export interface Look {
  coloring: Coloring;
  map: Exclude<MapName, "blue_red">;
  /** The value at the upper end of the scale, in the unit of the column. */
  top: number;
  grid: boolean;
  overlay: boolean;
  /** 0: the source as it was sent; 1: moved rigidly onto the target. */
  pose: number;
  lines: boolean;
  /** Share of the picture's depth that is cut away; null: nothing. */
  section: number | null;
  opacity: number;
}

/** A vertex under the pointer, and what corresponds to it. */
export interface Picked {
  side: Side;
  vertex: number;
  /** For a source vertex the nearest target vertex, -1 without counterpart; for a target vertex all source vertices. */
  others: number[];
  spread_mm: number;
}

const LINES = 240;
const MARKS = 64;
/** A picture that takes longer is drawn with fewer triangles until the view rests. */
const SLOW_MS = 45;
const REST_MS = 250;
/** Cells along the longest side of the surface from which one vertex each is kept then. */
const CELLS = 56;

/** The triangles between one vertex of each cell of a grid: a surface of fewer triangles over the same vertices. */
function coarseIndex(geometry: BufferGeometry): BufferAttribute {
  geometry.computeBoundingBox();
  const { min, max } = geometry.boundingBox!;
  const cell = Math.max(max.x - min.x, max.y - min.y, max.z - min.z, 1e-9) / CELLS;
  const position = geometry.getAttribute("position");
  const first = new Map<number, number>();
  const kept = new Uint32Array(position.count);
  for (let v = 0; v < position.count; v++) {
    const [i, j, k] = [(position.getX(v) - min.x) / cell, (position.getY(v) - min.y) / cell, (position.getZ(v) - min.z) / cell].map(Math.floor) as [number, number, number];
    const key = (i * (CELLS + 1) + j) * (CELLS + 1) + k;
    const known = first.get(key);
    if (known === undefined) first.set(key, v);
    kept[v] = known ?? v;
  }
  const index = geometry.getIndex()!;
  const triangles: number[] = [];
  for (let t = 0; t < index.count; t += 3) {
    const [a, b, c] = [kept[index.getX(t)]!, kept[index.getX(t + 1)]!, kept[index.getX(t + 2)]!];
    if (a !== b && b !== c && a !== c) triangles.push(a, b, c);
  }
  return new BufferAttribute(Uint32Array.from(triangles), 1);
}

export class PairScene {
  readonly renderer: WebGLRenderer;
  readonly camera = new OrthographicCamera(-1, 1, 1, -1, -1000, 1000);
  readonly controls: TrackballControls;
  private readonly scene = new Scene();
  private readonly groups: Record<Side, Group> = { source: new Group(), target: new Group() };
  private readonly meshes: Record<Side, Mesh<BufferGeometry, ShaderMaterial>>;
  private readonly marks: Record<Side, InstancedMesh>;
  private readonly halos: Record<Side, Mesh>;
  private readonly lines: LineSegments<BufferGeometry, LineBasicMaterial>;
  private readonly lineRows: number[];
  private readonly crosses: Record<Side, LineSegments<BufferGeometry, LineBasicMaterial>>;
  private readonly pose = new Matrix4();
  private readonly centers: { source: Vector3; moved: Vector3 };
  private readonly maps: Record<Look["map"] | "outlier", DataTexture>;
  /** How far both surfaces reach from the middle along the axes of the target. */
  private readonly reach = new Vector3();
  private readonly sizes = new ResizeObserver(() => this.resize());
  private look: Look;
  private isSlow = false;
  private isWhole = true;
  private readonly indices: Record<Side, { whole: BufferAttribute; coarse?: BufferAttribute }>;
  private waiting = 0;
  private isDirty = true;
  private radius: number;

  constructor(
    readonly canvas: HTMLCanvasElement,
    readonly pair: Pair,
    look: Look,
  ) {
    this.look = look;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: false });
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio));
    this.renderer.autoClear = false;
    const texture = (bytes: Uint8Array) => {
      const made = new DataTexture(bytes, STEPS, 1);
      made.needsUpdate = true;
      return made;
    };
    this.maps = { viridis: texture(colorMap("viridis")), cividis: texture(colorMap("cividis")), outlier: texture(outlierMap()) };
    const { frame } = pair;
    const positions = pair.target.getAttribute("position").array;
    pair.target.setAttribute("place", placesIn(frame, positions, () => true));
    pair.source.setAttribute("place", placesIn(frame, pair.images, (v) => pair.nearest[v]! >= 0));
    this.indices = { source: { whole: pair.source.getIndex()! }, target: { whole: pair.target.getIndex()! } };
    this.meshes = { source: this.surface(pair.source), target: this.surface(pair.target) };
    const size = Math.max(1e-6, frame.high.x - frame.low.x);
    const ball = new SphereGeometry(size * 0.009, 16, 12);
    this.marks = { source: this.marksOf(ball), target: this.marksOf(ball) };
    this.halos = { source: this.halo(), target: this.halo() };
    this.crosses = { source: this.crossOf(size), target: this.crossOf(size) };
    for (const side of ["source", "target"] as const) {
      this.groups[side].add(this.meshes[side], this.marks[side], this.halos[side], this.crosses[side]);
      this.scene.add(this.groups[side]);
    }
    this.radius = pair.target.boundingSphere!.radius;
    const source = pair.source.boundingSphere!.center.clone();
    this.centers = { source, moved: source.clone().applyMatrix4(pair.targetFromSource) };

    this.reach.copy(frame.low).negate().max(frame.high);
    const [p, from] = [new Vector3(), pair.source.getAttribute("position")];
    for (let v = 0; v < from.count; v++) {
      p.fromBufferAttribute(from, v).applyMatrix4(pair.targetFromSource).sub(frame.center);
      this.reach.max(new Vector3(...frame.axes.map((axis) => Math.abs(p.dot(axis)))));
    }

    const inliers: number[] = [];
    pair.inlier.forEach((is, v) => is && pair.nearest[v]! >= 0 && inliers.push(v));
    const step = Math.max(1, Math.floor(inliers.length / LINES));
    this.lineRows = inliers.filter((_, k) => k % step === 0);
    const ends = new BufferGeometry();
    ends.setAttribute("position", new BufferAttribute(new Float32Array(6 * this.lineRows.length), 3));
    this.lines = new LineSegments(ends, new LineBasicMaterial({ transparent: true, opacity: 0.55, depthTest: false }));
    this.lines.frustumCulled = false;
    this.scene.add(this.lines);

    this.controls = new TrackballControls(this.camera, canvas);
    this.controls.staticMoving = true;
    this.controls.rotateSpeed = 3;
    this.controls.zoomSpeed = 1.4;
    this.controls.addEventListener("change", () => this.redraw());
    this.view();
    this.set(look);
    this.sizes.observe(canvas);
    let before = 0;
    let drawn = 0;
    const loop = (now: number) => {
      this.waiting = requestAnimationFrame(loop);
      this.controls.update();
      const waited = now - before;
      before = now;
      if (this.isDirty) {
        // Two pictures in succession that take too long: a slow graphics processor, or none.
        if (now - drawn < 1000 && drawn > 0 && waited > SLOW_MS) this.isSlow = true;
        this.detail(!(this.isSlow && now - drawn < REST_MS));
        drawn = now;
        this.draw();
      } else if (!this.isWhole && now - drawn > REST_MS) {
        this.detail(true);
        this.draw();
      }
    };
    loop(performance.now());
  }

  dispose(): void {
    cancelAnimationFrame(this.waiting);
    this.sizes.disconnect();
    this.controls.dispose();
    this.renderer.dispose();
    this.pair.source.dispose();
    this.pair.target.dispose();
  }

  private surface(geometry: BufferGeometry): Mesh<BufferGeometry, ShaderMaterial> {
    geometry.setAttribute("value", new BufferAttribute(new Float32Array(geometry.getAttribute("position").count), 1));
    const material = coloredMaterial(this.maps.viridis);
    const mesh = new Mesh(geometry, material);
    mesh.matrixAutoUpdate = false;
    return mesh;
  }

  /** Draws all triangles, or as many as a slow machine can while the view moves. */
  private detail(whole: boolean): void {
    if (whole === this.isWhole) return;
    this.isWhole = whole;
    for (const side of ["source", "target"] as const) {
      const index = this.indices[side];
      index.coarse ??= coarseIndex(this.pair[side]);
      this.pair[side].setIndex(whole ? index.whole : index.coarse);
    }
  }

  private marksOf(ball: SphereGeometry): InstancedMesh {
    const marks = new InstancedMesh(ball, new MeshBasicMaterial({ color: 0xff2d95, depthTest: false }), MARKS);
    marks.count = 0;
    marks.renderOrder = 3;
    marks.frustumCulled = false;
    return marks;
  }

  /** Three lines along the axes of RAS that meet in a point. */
  private crossOf(size: number): LineSegments<BufferGeometry, LineBasicMaterial> {
    const ends = [0, 1, 2].flatMap((axis) => [-1, 1].flatMap((sign) => [0, 1, 2].map((k) => (k === axis ? sign * size : 0))));
    const geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(Float32Array.from(ends), 3));
    const cross = new LineSegments(geometry, new LineBasicMaterial({ color: 0xff2d95, depthTest: false }));
    cross.renderOrder = 4;
    cross.visible = false;
    cross.frustumCulled = false;
    return cross;
  }

  /** Where the crosshair is, in the space of the target; null: nowhere. */
  cross(point: Vector3 | null): void {
    for (const side of ["source", "target"] as const) {
      this.crosses[side].visible = point !== null;
      if (point) this.crosses[side].position.copy(point);
    }
    this.redraw();
  }

  /** The place of a vertex in the space of the target. */
  placeOf({ side, vertex }: Picked): Vector3 {
    const place = new Vector3().fromBufferAttribute(this.pair[side].getAttribute("position"), vertex);
    return side === "source" ? place.applyMatrix4(this.pair.targetFromSource) : place;
  }

  private halo(): Mesh {
    const halo = new Mesh(new SphereGeometry(1, 32, 24), new MeshBasicMaterial({ color: 0xff2d95, transparent: true, opacity: 0.28, depthTest: false }));
    halo.visible = false;
    halo.renderOrder = 2;
    return halo;
  }

  /** Looks at the target from its flattest side, its longest axis from left to right. */
  view(): void {
    const { center, axes } = this.pair.frame;
    this.controls.target.copy(center);
    this.camera.up.copy(axes[1]);
    this.camera.position.copy(center).addScaledVector(axes[2], 4 * this.radius);
    this.camera.near = -20 * this.radius;
    this.camera.far = 40 * this.radius;
    this.camera.zoom = 1;
    this.camera.lookAt(center);
    this.resize();
  }

  /** Turns the view by these angles, in radians. */
  turn(right: number, up: number): void {
    const eye = this.camera.position.clone().sub(this.controls.target);
    const side = new Vector3().crossVectors(this.camera.up, eye).normalize();
    const turned = new Quaternion().setFromAxisAngle(this.camera.up.clone().normalize(), right);
    turned.premultiply(new Quaternion().setFromAxisAngle(side, up));
    eye.applyQuaternion(turned);
    this.camera.up.applyQuaternion(turned).normalize();
    this.camera.position.copy(this.controls.target).add(eye);
    this.camera.lookAt(this.controls.target);
    this.redraw();
  }

  zoom(factor: number): void {
    this.camera.zoom = Math.min(40, Math.max(0.2, this.camera.zoom * factor));
    this.camera.updateProjectionMatrix();
    this.redraw();
  }

  set(look: Look): void {
    const { pair } = this;
    this.look = look;
    const map = look.coloring === "outlier" ? this.maps.outlier : this.maps[look.map];
    for (const side of ["source", "target"] as const) {
      const { uniforms } = this.meshes[side].material;
      uniforms.map!.value = map;
      uniforms.byPlace!.value = look.coloring === "correspondence";
      uniforms.grid!.value = look.grid && look.coloring === "correspondence";
      uniforms.low!.value = look.coloring === "displacement" ? -look.top : 0;
      uniforms.top!.value = look.coloring === "outlier" ? 1 : Math.max(1e-9, look.top);
      if (look.coloring !== "correspondence") {
        const values = side === "source" ? pair.columns[look.coloring] : pair.onTarget[look.coloring];
        const attribute = this.meshes[side].geometry.getAttribute("value") as BufferAttribute;
        // No NaN: what shaders do with it differs.
        for (let v = 0; v < values.length; v++) attribute.array[v] = Number.isNaN(values[v]!) ? -1e9 : values[v]!;
        attribute.needsUpdate = true;
      }
    }
    const source = this.meshes.source.material;
    source.transparent = look.overlay && look.opacity < 1;
    source.depthWrite = !source.transparent;
    source.uniforms.opacity!.value = look.overlay ? look.opacity : 1;
    this.meshes.source.renderOrder = 1;
    this.move();
    this.resize();
  }

  /** The pose between the original one and the aligned one: rotation along an arc, the center along a line. */
  private move(): void {
    const [position, rotation, scale] = [new Vector3(), new Quaternion(), new Vector3()];
    this.pair.targetFromSource.decompose(position, rotation, scale);
    const t = this.look.pose;
    const turned = new Quaternion().slerp(rotation, t);
    const scaled = new Vector3(1, 1, 1).lerp(scale, t);
    const center = this.centers.source.clone().lerp(this.centers.moved, t);
    const linear = new Matrix4().compose(new Vector3(), turned, scaled);
    position.copy(center).sub(this.centers.source.clone().applyMatrix4(linear));
    this.pose.compose(position, turned, scaled);
    this.meshes.source.matrix.copy(t === 1 ? this.pair.targetFromSource : this.pose);
    this.pose.copy(this.meshes.source.matrix);
    this.meshes.source.material.uniforms.pose!.value.copy(this.pose);
    this.redraw();
  }

  private isStacked(): boolean {
    return this.canvas.clientWidth < 1.25 * this.canvas.clientHeight;
  }

  private resize(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    const panels = this.look.overlay ? 1 : 2;
    const stacked = this.isStacked();
    const [w, h] = [stacked ? width : width / panels, stacked ? height / panels : height];
    let [x, y] = [2.2 * this.reach.x, 2.3 * Math.max(this.reach.y, this.reach.z)];
    if (this.look.overlay) {
      const away = this.centers.source.distanceTo(this.centers.moved) * (1 - this.look.pose);
      const extra = 2 * away + (away > 0 ? this.radius : 0);
      [x, y] = [x + extra, y + extra];
    }
    const perPixel = Math.max(x / w, y / h);
    this.camera.left = (-width * perPixel) / 2;
    this.camera.right = (width * perPixel) / 2;
    this.camera.top = (height * perPixel) / 2;
    this.camera.bottom = (-height * perPixel) / 2;
    this.camera.updateProjectionMatrix();
    this.controls.handleResize();
    this.redraw();
  }

  redraw(): void {
    this.isDirty = true;
  }

  /** Shifts each surface to the middle of its half. */
  private arrange(): void {
    this.camera.updateMatrixWorld();
    const right = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 0);
    const up = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 1);
    const { source, target } = this.groups;
    source.position.set(0, 0, 0);
    target.position.set(0, 0, 0);
    if (!this.look.overlay) {
      const stacked = this.isStacked();
      const size = (stacked ? this.camera.top - this.camera.bottom : this.camera.right - this.camera.left) / this.camera.zoom / 4;
      const along = stacked ? up.negate() : right;
      source.position.addScaledVector(along, -size);
      target.position.addScaledVector(along, size);
      const center = this.centers.source.clone().applyMatrix4(this.pose);
      source.position.sub(center).add(this.centers.moved);
    }
    // Only an aligned source lies where the crosshair's place is.
    this.crosses.source.visible = this.crosses.target.visible && this.look.pose === 1;
    const section = new Vector4().copy(NO_SECTION);
    if (this.look.section !== null) {
      const toward = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 2);
      const at = this.pair.frame.center.dot(toward) + this.radius * (1 - 2 * this.look.section);
      section.set(toward.x, toward.y, toward.z, at);
    }
    for (const side of ["source", "target"] as const) this.meshes[side].material.uniforms.section!.value.copy(section);
    this.lines.visible = this.look.lines;
    if (this.look.lines) {
      const ends = this.lines.geometry.getAttribute("position") as BufferAttribute;
      const [from, p] = [this.pair.source.getAttribute("position"), new Vector3()];
      this.lineRows.forEach((v, k) => {
        p.fromBufferAttribute(from, v).applyMatrix4(this.pose).add(source.position);
        ends.setXYZ(2 * k, p.x, p.y, p.z);
        p.fromArray(this.pair.images, 3 * v).add(target.position);
        ends.setXYZ(2 * k + 1, p.x, p.y, p.z);
      });
      ends.needsUpdate = true;
    }
    this.scene.updateMatrixWorld();
  }

  draw(): void {
    this.isDirty = false;
    const { renderer, canvas } = this;
    const { clientWidth: width, clientHeight: height } = canvas;
    if (width === 0 || height === 0) return;
    this.arrange();
    const styles = getComputedStyle(canvas);
    renderer.setClearColor(new Color(styles.getPropertyValue("--canvas").trim() || "#f4f6f8"));
    this.lines.material.color.set(styles.getPropertyValue("--line").trim() || "#333333");
    renderer.setScissorTest(false);
    renderer.clear();
    if (this.look.overlay) {
      renderer.render(this.scene, this.camera);
      return;
    }
    const { source, target } = this.groups;
    const lines = this.lines.visible;
    const stacked = this.isStacked();
    this.lines.visible = false;
    renderer.setScissorTest(true);
    for (const [group, other, k] of [[source, target, 0], [target, source, 1]] as const) {
      group.visible = true;
      other.visible = false;
      if (stacked) renderer.setScissor(0, k === 0 ? height / 2 : 0, width, height / 2);
      else renderer.setScissor((k * width) / 2, 0, width / 2, height);
      renderer.render(this.scene, this.camera);
    }
    renderer.setScissorTest(false);
    source.visible = target.visible = true;
    if (lines) {
      source.visible = target.visible = false;
      this.lines.visible = true;
      renderer.render(this.scene, this.camera);
      source.visible = target.visible = true;
    }
  }

  /** The vertex at this place of the canvas, in CSS pixels. */
  pick(x: number, y: number): Picked | null {
    this.detail(true);
    const { clientWidth: width, clientHeight: height } = this.canvas;
    this.arrange();
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2((2 * x) / width - 1, 1 - (2 * y) / height), this.camera);
    let sides: Side[] = ["source", "target"];
    if (!this.look.overlay) {
      const isSecond = this.isStacked() ? y > height / 2 : x > width / 2;
      sides = [isSecond ? "target" : "source"];
    }
    const section = this.meshes.target.material.uniforms.section!.value as Vector4;
    const isCut = (side: Side, point: Vector3) => point.clone().sub(this.groups[side].position).dot(new Vector3(section.x, section.y, section.z)) > section.w;
    const hits = sides
      .flatMap((side) => ray.intersectObject(this.meshes[side]).map((hit) => ({ side, hit })))
      .filter(({ side, hit }) => !isCut(side, hit.point))
      .sort((a, b) => a.hit.distance - b.hit.distance);
    const first = hits[0];
    if (first === undefined || !first.hit.face) return null;
    const { side, hit } = first;
    const at = this.meshes[side].worldToLocal(hit.point.clone());
    const corners = [hit.face!.a, hit.face!.b, hit.face!.c];
    const position = this.meshes[side].geometry.getAttribute("position");
    const distance = (v: number) => at.distanceToSquared(new Vector3().fromBufferAttribute(position, v));
    const vertex = corners.reduce((best, v) => (distance(v) < distance(best) ? v : best));
    return this.describe(side, vertex);
  }

  describe(side: Side, vertex: number): Picked {
    const { pair } = this;
    if (side === "source") {
      return { side, vertex, others: [pair.nearest[vertex]!], spread_mm: pair.columns.spread[vertex]! };
    }
    const others = [...pair.sources.slice(pair.starts[vertex], pair.starts[vertex + 1])];
    const spreads = others.map((s) => pair.columns.spread[s]!).filter((spread) => !Number.isNaN(spread));
    return { side, vertex, others, spread_mm: spreads.length > 0 ? Math.max(...spreads) : NaN };
  }

  /** Marks a vertex and what corresponds to it on the other surface, with its spread. */
  mark(picked: Picked | null): void {
    for (const side of ["source", "target"] as const) {
      this.marks[side].count = 0;
      this.halos[side].visible = false;
    }
    if (picked !== null) {
      const { pair } = this;
      const place = (side: Side, v: number) => new Vector3().fromBufferAttribute(pair[side].getAttribute("position"), v).applyMatrix4(side === "source" ? this.pose : new Matrix4());
      const put = (side: Side, points: Vector3[]) => {
        points.slice(0, MARKS).forEach((p, k) => this.marks[side].setMatrixAt(k, new Matrix4().makeTranslation(p.x, p.y, p.z)));
        this.marks[side].count = Math.min(MARKS, points.length);
        this.marks[side].instanceMatrix.needsUpdate = true;
      };
      put(picked.side, [place(picked.side, picked.vertex)]);
      const other: Side = picked.side === "source" ? "target" : "source";
      let points: Vector3[];
      if (picked.side === "source") {
        points = picked.others[0]! < 0 ? [] : [new Vector3().fromArray(pair.images, 3 * picked.vertex)];
      } else {
        points = picked.others.map((s) => place("source", s));
      }
      put(other, points);
      if (points.length > 0 && picked.spread_mm > 0) {
        const center = points.reduce((sum, p) => sum.add(p), new Vector3()).divideScalar(points.length);
        this.halos[other].position.copy(center);
        this.halos[other].scale.setScalar(picked.spread_mm);
        this.halos[other].visible = true;
      }
    }
    this.redraw();
  }

  /** Where a vertex is on the canvas, in CSS pixels, and whether its side of the surface faces the viewer. */
  project(side: Side, vertex: number): { x: number; y: number; facing: number } {
    this.arrange();
    const { geometry, matrixWorld } = this.meshes[side];
    const p = new Vector3().fromBufferAttribute(geometry.getAttribute("position"), vertex).applyMatrix4(matrixWorld);
    const n = new Vector3().fromBufferAttribute(geometry.getAttribute("normal"), vertex).transformDirection(matrixWorld);
    const toward = new Vector3().setFromMatrixColumn(this.camera.matrixWorld, 2);
    p.project(this.camera);
    const { clientWidth: width, clientHeight: height } = this.canvas;
    return { x: ((p.x + 1) / 2) * width, y: ((1 - p.y) / 2) * height, facing: n.dot(toward) };
  }

  /** Milliseconds for each of `n` frames while the view turns, each until its pixels are there. */
  frameTimes(n: number, whole: boolean): number[] {
    this.detail(whole);
    const gl = this.renderer.getContext();
    const pixel = new Uint8Array(4);
    return Array.from({ length: n }, () => {
      const began = performance.now();
      this.turn(0.05, 0.01);
      this.draw();
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      return performance.now() - began;
    });
  }

  picture(): Promise<Blob | null> {
    this.draw();
    return new Promise((resolve) => this.canvas.toBlob(resolve, "image/png"));
  }
}
