import numpy as np, sys, re, json
def rx(r): p,b=divmod(r,64); return p%2*8+b%8
def ry(r): p,b=divmod(r,64); return p//2*8+b//8
own=np.array([(rx(r)+2*ry(r))%4 for r in range(256)])
grp=np.array([next(g for g in range(4) if (q%4)==(g+2*(q//4))%4) for q in range(16)])
lane=own[:,None]*4+grp[None,:]
scene,run,top=sys.argv[1],sys.argv[2],int(sys.argv[3])
d=np.fromfile(scene+'.3500.load',dtype=np.uint32).reshape(-1,256,16).astype(np.int64)
L=np.stack([d[:,lane==k].sum(1) for k in range(16)],1).max(1)
rows=[re.findall(r'-?\d+|[A-Z](?=\d)',l) for l in open(run+'.err') if l.startswith('walk')]
prev=0; out={}
for r in rows:
    w=int(r[1]); end=int(r[7]); out.setdefault(w,[0,0,0,0]); out[w][0]+=end-prev; prev=end
    out[w][1]=max(out[w][1],int(r[4])); out[w][2]=r[5]; out[w][3]+=1
ends=json.load(open(run+'.json'))['window_ends']
walks={int(l.split()[1]):l.split()[4:] for l in open(scene+'.3500.walks') if l[0]!='#' and l.split()[2]=='W'}
t=sorted(out,key=lambda w:-(out[w][0]-L[w]))
print('sum cycles',sum(v[0] for v in out.values()),'sum RU bound',L.sum())
print('win walks cycles RUbound lost peak done | count chunks gauss surv rec')
for w in (t[:top] if top>0 else range(len(out))): print(w,out[w][3],out[w][0],L[w],out[w][0]-L[w],out[w][1],out[w][2],'|',*walks[w])
