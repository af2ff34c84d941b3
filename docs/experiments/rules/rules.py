"""Which walks a window is, by rules over what `X_DUMP` wrote; as plan files for `X_BATCH`."""
import numpy as np, sys
class Scene:
    def __init__(s, base):
        rows=[l.split() for l in open(base+'.walks') if l[0]!='#']
        s.nb=int(open(base+'.walks').readline().split()[2])
        s.walks=[(int(r[1]),r[2],int(r[3])) for r in rows]
        s.count=np.array([[int(v) for v in r[4:]] for r in rows])  # count chunks gaussians survivors records
        s.at={w:i for i,w in enumerate(s.walks)}
        s.windows=sorted({w[0] for w in s.walks})
        f=lambda e,c: np.fromfile(base+e,dtype=np.int32).reshape(-1,c)
        s.rec,s.chk,s.grp,=f('.rec',4),f('.chk',5),f('.grp',5)
        n=len(rows)
        def prof(w,a,b,v):
            d=np.zeros((n,s.nb+1)); np.add.at(d,(w,a),v); np.add.at(d,(w,np.maximum(a,b)+1),-v)
            return d.cumsum(1)[:,:s.nb]
        g=s.grp
        s.prof={'g':prof(g[:,0],g[:,1],g[:,2],g[:,3]),'w':prof(g[:,0],g[:,1],g[:,2],g[:,3]*g[:,4]/256),
                'c':prof(s.chk[:,0],s.chk[:,1],s.chk[:,2],s.chk[:,4]),
                'r':prof(s.rec[:,0],s.rec[:,1],s.rec[:,2],s.rec[:,3])}
        s.peak={k:v.max(1) for k,v in s.prof.items()}
        s.peak['a']=s.count[:,0]
        s.peak['A']=np.bincount(g[:,0],g[:,3]*g[:,4]/256,minlength=n)
    def get(s,w,v,p=0): return s.at.get((w,v,p))
def rule(s,kind,cap,halves=False,small=False,limit=None):
    """plan: {window: [walks]}; limit: bucket of each window at which it was opaque in the frame before"""
    pk=lambda i,w: (s.prof[kind][i,:limit[w]+1].max() if limit is not None and limit.get(w) is not None else s.peak[kind][i])
    plan={}
    for w in s.windows:
        if pk(s.get(w,'W'),w)<=cap or s.get(w,'F',0) is None and not any(s.get(w,'F',p) is not None for p in range(4)): continue
        if halves:
            best=None
            for v in 'HV':
                ids=[s.get(w,v,i) for i in (0,1)]
                if all(i is None or pk(i,w)<=cap for i in ids):
                    t=max(pk(i,w) for i in ids if i is not None)
                    if best is None or t<best[0]: best=(t,v)
            if best: plan[w]=[best[1]+'0',best[1]+'1']; continue
        out=[]
        for p in range(4):
            i=s.get(w,'F',p)
            if i is None: continue
            if small and pk(i,w)>cap and any(s.get(w,'S',4*p+q) is not None for q in range(4)):
                out+=['S%d'%(4*p+q) for q in range(4) if s.get(w,'S',4*p+q) is not None]
            else: out.append('F%d'%p)
        plan[w]=out
    return plan
def write(plan,name):
    with open(name,'w') as f:
        for w,x in sorted(plan.items()): f.write('%d %s\n'%(w,' '.join(x)))
