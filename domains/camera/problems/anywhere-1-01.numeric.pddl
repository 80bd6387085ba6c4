; Problem anywhere-1-01 of the learned domain camera, in numbers.
; How it came about: anywhere, drawn with seed 2; draw 1.
; A goal is met within 50 mm; what is asked for lies inside that by as
; much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem anywhere-1-01)
  (:domain camera-numeric)
  (:objects
    item-01 - kind-01
    m-0101-item-01 m-0110-item-01 m-0111-item-01 m-1110b-item-01 m-1111-item-01 m-0000-item-01 m-1000-item-01 m-1001-item-01 m-0001-item-01 m-0011a-item-01 m-0100a-item-01 m-1011-item-01 - motion)
  (:init
    (hand-empty)
    ; item-01 lies at (0.8146, -0.1249, 0.0175) m at first
    (pushes item-01 m-0101-item-01) (pushes item-01 m-0110-item-01) (pushes item-01 m-0111-item-01) (pushes item-01 m-1110b-item-01) (pushes item-01 m-1111-item-01) (pushes item-01 m-0000-item-01) (pushes item-01 m-1000-item-01) (pushes item-01 m-1001-item-01) (pushes item-01 m-0001-item-01) (pushes item-01 m-0011a-item-01) (pushes item-01 m-0100a-item-01) (pushes item-01 m-1011-item-01)
    (= (x item-01) 4646) (= (y item-01) 1751) (= (z item-01) 0)
    (= (along-x m-0101-item-01) 9324) (= (along-y m-0101-item-01) 9786) (= (along-z m-0101-item-01) 10000)
    (= (along-x m-0110-item-01) 9752) (= (along-y m-0110-item-01) 10200) (= (along-z m-0110-item-01) 10000)
    (= (along-x m-0111-item-01) 9394) (= (along-y m-0111-item-01) 10078) (= (along-z m-0111-item-01) 10000)
    (= (along-x m-1110b-item-01) 9634) (= (along-y m-1110b-item-01) 10148) (= (along-z m-1110b-item-01) 10000)
    (= (along-x m-1111-item-01) 9604) (= (along-y m-1111-item-01) 9560) (= (along-z m-1111-item-01) 10000)
    (= (along-x m-0000-item-01) 10458) (= (along-y m-0000-item-01) 10122) (= (along-z m-0000-item-01) 10000)
    (= (along-x m-1000-item-01) 10811) (= (along-y m-1000-item-01) 9838) (= (along-z m-1000-item-01) 10000)
    (= (along-x m-1001-item-01) 10260) (= (along-y m-1001-item-01) 9791) (= (along-z m-1001-item-01) 10000)
    (= (along-x m-0001-item-01) 9788) (= (along-y m-0001-item-01) 10386) (= (along-z m-0001-item-01) 10000)
    (= (along-x m-0011a-item-01) 10139) (= (along-y m-0011a-item-01) 10075) (= (along-z m-0011a-item-01) 10000)
    (= (along-x m-0100a-item-01) 9847) (= (along-y m-0100a-item-01) 10347) (= (along-z m-0100a-item-01) 10000)
    (= (along-x m-1011-item-01) 9667) (= (along-y m-1011-item-01) 9232) (= (along-z m-1011-item-01) 10000)
    (= (total-cost) 0) (= (cost m-0101-item-01) 5) (= (cost m-0110-item-01) 34) (= (cost m-0111-item-01) 23) (= (cost m-1110b-item-01) 28) (= (cost m-1111-item-01) 28) (= (cost m-0000-item-01) 5) (= (cost m-1000-item-01) 9) (= (cost m-1001-item-01) 18) (= (cost m-0001-item-01) 5) (= (cost m-0011a-item-01) 5) (= (cost m-0100a-item-01) 5) (= (cost m-1011-item-01) 28)
  )
  (:goal (and (<= (x item-01) 3298) (>= (x item-01) 2388) (<= (+ (x item-01) (y item-01)) 5374) (>= (+ (x item-01) (y item-01)) 4087) (<= (y item-01) 2343) (>= (y item-01) 1433) (<= (+ (y item-01) 312) (x item-01)) (<= (x item-01) (+ (y item-01) 1599)) (>= (z item-01) 0) (<= (z item-01) 0)))
  (:metric minimize (total-cost)))
