// SPDX-License-Identifier: MIT
// Where were the bodies of a world before its last step?

export class PosesBefore {
  #kept = new Float64Array(32);
  #count = 0;
  #view = this.#kept.subarray(0, 0);

  #reserve(count) {
    if (count <= this.#kept.length) return;
    const longer = new Float64Array(2 * count);
    longer.set(this.#kept);
    this.#kept = longer;
  }
  /** To be called before each step. */
  keep(poses) {
    this.#reserve(poses.length);
    this.#kept.set(poses);
    this.#count = poses.length;
  }
  /** A new body has this index. */
  forget(index) {
    if (3 * index < this.#count) this.#kept.fill(NaN, 3 * index, 3 * index + 3);
  }
  /** As many numbers as there are poses now. A body that came after the step is where it is now. */
  beside(poses) {
    this.#reserve(poses.length);
    for (let i = 0; i < poses.length; ++i)
      if (i >= this.#count || Number.isNaN(this.#kept[i])) this.#kept[i] = poses[i];
    this.#count = Math.max(this.#count, poses.length);
    if (this.#view.buffer !== this.#kept.buffer || this.#view.length !== poses.length)
      this.#view = this.#kept.subarray(0, poses.length);
    return this.#view;
  }
}
